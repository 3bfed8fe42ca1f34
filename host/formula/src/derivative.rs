//! The derivative of a list of operations.

use crate::function::{BinaryFunction, Function};
use crate::graph::{Graph, Node, Operation};

/// Adds the derivative of a node with respect to a variable to its graph.
///
/// At a kink it is that of one side: of `abs(a)` it is `sign(a) a'`, of `if` that of the branch
/// taken; of a jump it is 0.
pub(crate) fn derivative(graph: &mut Graph, node: Node, variable: usize) -> Node {
    let zero = graph.number(0.0);
    let mut slopes = vec![zero; node + 1];
    for place in 0..=node {
        slopes[place] = match graph.operations[place] {
            Operation::Number(_) => zero,
            Operation::Variable(of) => graph.number(f64::from(u8::from(of == variable))),
            Operation::Call(function, a) => {
                let slope = slopes[a];
                match graph.value(slope) {
                    Some(0.0) => zero,
                    _ => of_call(graph, function, (a, slope), place),
                }
            }
            Operation::Pair(binary, a, b) => {
                of_pair(graph, binary, [(a, slopes[a]), (b, slopes[b])], place)
            }
            Operation::Choice(condition, a, b) => graph.choice(condition, slopes[a], slopes[b]),
        };
    }
    slopes[node]
}

/// Of `value = function(a)`.
fn of_call(graph: &mut Graph, function: Function, (a, slope): (Node, Node), value: Node) -> Node {
    use BinaryFunction::{Add, Divide, Multiply, Subtract};
    let one = graph.number(1.0);
    let square = |graph: &mut Graph, node| graph.pair(Multiply, node, node);
    let factor = match function {
        Function::Abs => graph.call(Function::Sign, a),
        Function::Ceil | Function::Floor | Function::Sign => graph.number(0.0),
        Function::Acos | Function::Asin => {
            let square = square(graph, a);
            let rest = graph.pair(Subtract, one, square);
            let root = graph.call(Function::Sqrt, rest);
            let positive = graph.pair(Divide, one, root);
            match function {
                Function::Asin => positive,
                _ => graph.negative(positive),
            }
        }
        Function::Atan => {
            let square = square(graph, a);
            let below = graph.pair(Add, one, square);
            graph.pair(Divide, one, below)
        }
        Function::Cbrt => {
            let (three, square) = (graph.number(3.0), square(graph, value));
            let below = graph.pair(Multiply, three, square);
            graph.pair(Divide, one, below)
        }
        Function::Cos => {
            let sine = graph.call(Function::Sin, a);
            graph.negative(sine)
        }
        Function::Cosh => graph.call(Function::Sinh, a),
        Function::Erf => {
            let square = square(graph, a);
            let exponent = graph.negative(square);
            let bell = graph.call(Function::Exp, exponent);
            let factor = graph.number(std::f64::consts::FRAC_2_SQRT_PI);
            graph.pair(Multiply, factor, bell)
        }
        Function::Exp => value,
        Function::Log => graph.pair(Divide, one, a),
        Function::Log10 => {
            let ten = graph.number(std::f64::consts::LN_10);
            let below = graph.pair(Multiply, ten, a);
            graph.pair(Divide, one, below)
        }
        Function::Sin => graph.call(Function::Cos, a),
        Function::Sinh => graph.call(Function::Cosh, a),
        Function::Sqrt => {
            // a'/(2 √a), and 0 where a' is: r = √(x² + y²) is even at its centre.
            let two = graph.number(2.0);
            let below = graph.pair(Multiply, two, value);
            let quotient = graph.pair(Divide, slope, below);
            let zero = graph.number(0.0);
            let is_flat = graph.pair(BinaryFunction::Equal, slope, zero);
            return graph.choice(is_flat, zero, quotient);
        }
        Function::Tan => {
            let square = square(graph, value);
            graph.pair(Add, one, square)
        }
        Function::Tanh => {
            let square = square(graph, value);
            graph.pair(Subtract, one, square)
        }
    };
    graph.pair(Multiply, factor, slope)
}

/// Of `value = binary(a, b)`, with the operands' derivatives.
fn of_pair(
    graph: &mut Graph,
    binary: BinaryFunction,
    [(a, a_slope), (b, b_slope)]: [(Node, Node); 2],
    value: Node,
) -> Node {
    use BinaryFunction::{Add, Divide, Multiply, Power, Subtract};
    match binary {
        Add | Subtract => graph.pair(binary, a_slope, b_slope),
        Multiply => {
            let left = graph.pair(Multiply, a_slope, b);
            let right = graph.pair(Multiply, a, b_slope);
            graph.pair(Add, left, right)
        }
        // (a' - (a/b) b')/b
        Divide => {
            let lost = graph.pair(Multiply, value, b_slope);
            let above = graph.pair(Subtract, a_slope, lost);
            graph.pair(Divide, above, b)
        }
        // b a^(b-1) a' + a^b log(a) b'
        Power => {
            let one = graph.number(1.0);
            let less = graph.pair(Subtract, b, one);
            let power = graph.pair(Power, a, less);
            let factor = graph.pair(Multiply, b, power);
            let of_base = graph.pair(Multiply, factor, a_slope);
            if graph.value(b_slope) == Some(0.0) {
                return of_base;
            }
            let log = graph.call(Function::Log, a);
            let factor = graph.pair(Multiply, value, log);
            let of_exponent = graph.pair(Multiply, factor, b_slope);
            graph.pair(Add, of_base, of_exponent)
        }
        // a' - floor(a/b) b'
        BinaryFunction::Remainder => {
            let quotient = graph.pair(Divide, a, b);
            let whole = graph.call(Function::Floor, quotient);
            let lost = graph.pair(Multiply, whole, b_slope);
            graph.pair(Subtract, a_slope, lost)
        }
        BinaryFunction::Minimum => {
            let is_first = graph.pair(BinaryFunction::Less, a, b);
            graph.choice(is_first, a_slope, b_slope)
        }
        BinaryFunction::Maximum => {
            let is_first = graph.pair(BinaryFunction::Less, b, a);
            graph.choice(is_first, a_slope, b_slope)
        }
        // (a' b - a b')/(a² + b²)
        BinaryFunction::Atan2 => {
            let left = graph.pair(Multiply, a_slope, b);
            let right = graph.pair(Multiply, a, b_slope);
            let above = graph.pair(Subtract, left, right);
            let (a, b) = (graph.pair(Multiply, a, a), graph.pair(Multiply, b, b));
            let below = graph.pair(Add, a, b);
            graph.pair(Divide, above, below)
        }
        BinaryFunction::Less | BinaryFunction::LessOrEqual | BinaryFunction::Equal => {
            graph.number(0.0)
        }
    }
}
