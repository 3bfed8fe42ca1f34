//! Signs and names to operations, by precedence: `||`, `&&`, comparisons, `+ -`, `* / %`, signs,
//! `^` (which binds to the right, and tighter than a sign before it: `-2^2 = -4`).

use std::ops::Range;

use crate::error::{FormulaError, FormulaFault};
use crate::function::{BINARY, BinaryFunction, FUNCTIONS};
use crate::graph::{Graph, MOST, Node};
use crate::scope::{Definition, IF, PI, Scope};
use crate::token::{Token, tokens};

/// The deepest nesting of parentheses, signs and definitions.
const DEEPEST: usize = 200;

/// Reads one text.
pub(crate) struct Parser<'a, 'g> {
    scope: &'a Scope,
    graph: &'g mut Graph,
    text: &'a str,
    tokens: Vec<(Token<'a>, Range<usize>)>,
    next: usize,
    /// What the parameters of the definition stand for.
    arguments: &'a [(String, Node)],
    /// The definitions that are being read, the outermost first.
    within: Vec<&'a str>,
    depth: usize,
}

type Read = Result<Node, FormulaError>;

impl<'a, 'g> Parser<'a, 'g> {
    /// Reads a formula into a graph.
    pub fn formula(scope: &'a Scope, graph: &'g mut Graph, text: &'a str) -> Read {
        Self::whole(scope, graph, (text, &[]), Vec::new(), 0)
    }

    /// Reads a definition into a graph, with what its parameters stand for.
    pub fn definition(
        scope: &'a Scope,
        graph: &'g mut Graph,
        name: &'a str,
        arguments: &'a [(String, Node)],
    ) -> Read {
        let text = &scope.definitions[name].text;
        let read = Self::whole(scope, graph, (text, arguments), vec![name], 0);
        read.map_err(|error| within(error, name))
    }

    fn whole(
        scope: &'a Scope,
        graph: &'g mut Graph,
        (text, arguments): (&'a str, &'a [(String, Node)]),
        within: Vec<&'a str>,
        depth: usize,
    ) -> Read {
        let mut parser = Parser {
            scope,
            graph,
            text,
            tokens: tokens(text)?,
            next: 0,
            arguments,
            within,
            depth,
        };
        if parser.tokens.is_empty() {
            return Err(FormulaError::new(FormulaFault::Empty, 0..text.len()));
        }
        let node = parser.or()?;
        match parser.tokens.get(parser.next) {
            None => Ok(node),
            Some((Token::Sign(sign @ (")" | ",")), span)) => {
                let fault = FormulaFault::Stray((*sign).to_owned());
                Err(FormulaError::new(fault, span.clone()))
            }
            Some(_) => Err(parser.no_sign()),
        }
    }

    /// Takes a sign if it is the next one.
    fn takes(&mut self, sign: &str) -> bool {
        let is_next =
            matches!(self.tokens.get(self.next), Some((Token::Sign(next), _)) if *next == sign);
        self.next += usize::from(is_next);
        is_next
    }

    /// Takes the first of some signs that is the next one.
    fn one_of(&mut self, signs: &[&'static str]) -> Option<&'static str> {
        signs.iter().copied().find(|sign| self.takes(sign))
    }

    /// Bytes of the token before the next one.
    fn last(&self) -> Range<usize> {
        self.tokens[self.next - 1].1.clone()
    }

    /// The fault that two values stand side by side.
    fn no_sign(&self) -> FormulaError {
        let (left, right) = (self.last(), self.tokens[self.next].1.clone());
        let shown = |span: &Range<usize>| self.text[span.clone()].to_owned();
        let fault = FormulaFault::NoSign {
            left: shown(&left),
            right: shown(&right),
        };
        FormulaError::new(fault, right)
    }

    fn or(&mut self) -> Read {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.too_much("200 levels"));
        }
        if self.graph.operations.len() > MOST {
            return Err(self.too_much("20000 operations"));
        }
        let mut a = self.and()?;
        while self.takes("||") {
            let b = self.and()?;
            let (one, b) = (self.graph.number(1.0), self.truth(b));
            a = self.graph.choice(a, one, b);
        }
        self.depth -= 1;
        Ok(a)
    }

    fn too_much(&self, what: &'static str) -> FormulaError {
        FormulaError::new(FormulaFault::TooMuch(what), 0..self.text.len())
    }

    fn and(&mut self) -> Read {
        let mut a = self.comparison()?;
        while self.takes("&&") {
            let b = self.comparison()?;
            let (zero, b) = (self.graph.number(0.0), self.truth(b));
            a = self.graph.choice(a, b, zero);
        }
        Ok(a)
    }

    /// 1 where a node is not 0, else 0.
    fn truth(&mut self, node: Node) -> Node {
        let (zero, one) = (self.graph.number(0.0), self.graph.number(1.0));
        self.graph.choice(node, one, zero)
    }

    fn comparison(&mut self) -> Read {
        const SIGNS: [&str; 6] = ["<=", ">=", "==", "!=", "<", ">"];
        let a = self.sum()?;
        let Some(sign) = self.one_of(&SIGNS) else {
            return Ok(a);
        };
        let b = self.sum()?;
        let node = match sign {
            "<" => self.graph.pair(BinaryFunction::Less, a, b),
            ">" => self.graph.pair(BinaryFunction::Less, b, a),
            "<=" => self.graph.pair(BinaryFunction::LessOrEqual, a, b),
            ">=" => self.graph.pair(BinaryFunction::LessOrEqual, b, a),
            _ => self.graph.pair(BinaryFunction::Equal, a, b),
        };
        if self.one_of(&SIGNS).is_some() {
            return Err(FormulaError::new(FormulaFault::Chained, self.last()));
        }
        if sign != "!=" {
            return Ok(node);
        }
        let one = self.graph.number(1.0);
        Ok(self.graph.pair(BinaryFunction::Subtract, one, node))
    }

    fn sum(&mut self) -> Read {
        let mut a = self.product()?;
        while let Some(sign) = self.one_of(&["+", "-"]) {
            let b = self.product()?;
            let binary = match sign {
                "+" => BinaryFunction::Add,
                _ => BinaryFunction::Subtract,
            };
            a = self.graph.pair(binary, a, b);
        }
        Ok(a)
    }

    fn product(&mut self) -> Read {
        let mut a = self.signed()?;
        while let Some(sign) = self.one_of(&["*", "/", "%"]) {
            let b = self.signed()?;
            let binary = match sign {
                "*" => BinaryFunction::Multiply,
                "/" => BinaryFunction::Divide,
                _ => BinaryFunction::Remainder,
            };
            a = self.graph.pair(binary, a, b);
        }
        Ok(a)
    }

    fn signed(&mut self) -> Read {
        let Some(sign) = self.one_of(&["-", "+", "!"]) else {
            return self.power();
        };
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.too_much("200 levels"));
        }
        let a = self.signed()?;
        self.depth -= 1;
        Ok(match sign {
            "-" => self.graph.negative(a),
            "+" => a,
            _ => {
                let (zero, one) = (self.graph.number(0.0), self.graph.number(1.0));
                self.graph.choice(a, zero, one)
            }
        })
    }

    fn power(&mut self) -> Read {
        let a = self.value()?;
        if self.one_of(&["^", "**"]).is_none() {
            return Ok(a);
        }
        let b = self.signed()?;
        Ok(self.graph.pair(BinaryFunction::Power, a, b))
    }

    /// A number, a name, a call or a parenthesis.
    fn value(&mut self) -> Read {
        let Some((token, span)) = self.tokens.get(self.next).cloned() else {
            let end = self.text.trim_end().len();
            return Err(FormulaError::new(FormulaFault::NoValue(None), end..end));
        };
        self.next += 1;
        match token {
            Token::Number(value) => Ok(self.graph.number(value)),
            Token::Name(name) => match self.takes("(") {
                true => self.called(name, span),
                false => self.named(name, span),
            },
            Token::Sign("(") => {
                let a = self.or()?;
                self.close(span)?;
                Ok(a)
            }
            Token::Sign(sign) => {
                let fault = FormulaFault::NoValue(Some(sign.to_owned()));
                Err(FormulaError::new(fault, span))
            }
        }
    }

    /// Closes a parenthesis that was opened somewhere.
    fn close(&mut self, open: Range<usize>) -> Result<(), FormulaError> {
        if self.takes(")") {
            return Ok(());
        }
        match self.tokens.get(self.next) {
            Some((Token::Number(_) | Token::Name(_) | Token::Sign("("), _)) => Err(self.no_sign()),
            Some((Token::Sign(sign), span)) => {
                let fault = FormulaFault::Stray((*sign).to_owned());
                Err(FormulaError::new(fault, span.clone()))
            }
            None => Err(FormulaError::new(FormulaFault::Open, open)),
        }
    }

    /// A name without arguments.
    fn named(&mut self, name: &'a str, span: Range<usize>) -> Read {
        if let Some((_, node)) = self
            .arguments
            .iter()
            .find(|(parameter, _)| parameter == name)
        {
            return Ok(*node);
        }
        if let Some(place) = self
            .scope
            .variables
            .iter()
            .position(|variable| variable == name)
        {
            return Ok(self.graph.variable(place));
        }
        if name == PI {
            return Ok(self.graph.number(std::f64::consts::PI));
        }
        match self.scope.definitions.get_key_value(name) {
            Some((
                name,
                Definition {
                    parameters: None, ..
                },
            )) => self.defined(name, &[], span),
            Some(_) => Err(FormulaError::new(
                FormulaFault::NotCalled(name.to_owned()),
                span,
            )),
            None if is_function(name) => Err(FormulaError::new(
                FormulaFault::NotCalled(name.to_owned()),
                span,
            )),
            None => Err(self.unknown(name, span)),
        }
    }

    /// A name with arguments, of which the parenthesis is open.
    fn called(&mut self, name: &'a str, span: Range<usize>) -> Read {
        let open = self.last();
        let mut arguments = Vec::new();
        while !self.takes(")") {
            arguments.push(self.or()?);
            if !self.takes(",") {
                self.close(open)?;
                break;
            }
        }
        let needs = |needs: &str| {
            let (name, needs) = (name.to_owned(), needs.to_owned());
            let found = arguments.len();
            let fault = FormulaFault::Arguments { name, needs, found };
            FormulaError::new(fault, span.clone())
        };
        if let Some((_, function)) = FUNCTIONS.iter().find(|of| of.0 == name) {
            let [a] = arguments[..] else {
                return Err(needs("one argument"));
            };
            return Ok(self.graph.call(*function, a));
        }
        if let Some((_, binary)) = BINARY.iter().find(|of| of.0 == name) {
            return match (arguments.len(), binary) {
                (2, _) => Ok(self.graph.pair(*binary, arguments[0], arguments[1])),
                (3.., BinaryFunction::Minimum | BinaryFunction::Maximum) => {
                    let rest = arguments[1..].iter();
                    Ok(rest.fold(arguments[0], |a, b| self.graph.pair(*binary, a, *b)))
                }
                _ => Err(needs("two arguments")),
            };
        }
        if name == IF {
            let [condition, a, b] = arguments[..] else {
                return Err(needs("three arguments, if(condition, a, b)"));
            };
            return Ok(self.graph.choice(condition, a, b));
        }
        match self.scope.definitions.get_key_value(name) {
            Some((
                name,
                Definition {
                    parameters: Some(parameters),
                    ..
                },
            )) => {
                if parameters.len() != arguments.len() {
                    return Err(needs(&format!("({})", parameters.join(", "))));
                }
                let arguments: Vec<_> = parameters.iter().cloned().zip(arguments).collect();
                self.defined(name, &arguments, span)
            }
            Some(_) => Err(FormulaError::new(
                FormulaFault::NotFunction(name.to_owned()),
                span,
            )),
            None if self.named(name, span.clone()).is_ok() => Err(FormulaError::new(
                FormulaFault::NotFunction(name.to_owned()),
                span,
            )),
            None => Err(self.unknown(name, span)),
        }
    }

    /// What a definition is for some arguments.
    fn defined(&mut self, name: &'a str, arguments: &[(String, Node)], span: Range<usize>) -> Read {
        if self.within.contains(&name) {
            return Err(FormulaError::new(
                FormulaFault::Circular(name.to_owned()),
                span,
            ));
        }
        let call = (
            name.to_owned(),
            arguments.iter().map(|of| of.1).collect::<Vec<_>>(),
        );
        if let Some(node) = self.graph.called.get(&call) {
            return Ok(*node);
        }
        let mut inside = self.within.clone();
        inside.push(name);
        let text = &self.scope.definitions[name].text;
        let read = Parser::whole(
            self.scope,
            self.graph,
            (text, arguments),
            inside,
            self.depth + 1,
        );
        let node = read.map_err(|error| within(error, name))?;
        self.graph.called.insert(call, node);
        Ok(node)
    }

    fn unknown(&self, name: &str, span: Range<usize>) -> FormulaError {
        let mut known: Vec<String> = self.arguments.iter().map(|of| of.0.clone()).collect();
        known.extend(self.scope.names());
        let fault = FormulaFault::Unknown {
            name: name.to_owned(),
            known,
        };
        FormulaError::new(fault, span)
    }
}

/// The innermost definition is the one whose text an error is about.
fn within(error: FormulaError, name: &str) -> FormulaError {
    FormulaError {
        definition: error.definition.or_else(|| Some(name.to_owned())),
        ..error
    }
}

fn is_function(name: &str) -> bool {
    let of_one = FUNCTIONS.iter().any(|of| of.0 == name);
    of_one || BINARY.iter().any(|of| of.0 == name) || name == IF
}
