//! A tree of places, for counting what lies around one whatever the spacing is there (Bentley,
//! Communications of the ACM 18 (1975) 509).

/// Places in the order of a balanced tree: the middle of every range splits it along one direction.
pub(super) struct Tree {
    nodes: Vec<Node>,
}

struct Node {
    place: [f64; 3],
    id: u32,
    axis: u8,
}

impl Tree {
    /// The tree of these places.
    pub fn new(places: &[[f64; 3]]) -> Self {
        let node = |(id, &place): (usize, &[f64; 3])| Node {
            place,
            id: id as u32,
            axis: 0,
        };
        let mut nodes: Vec<Node> = places.iter().enumerate().map(node).collect();
        split(&mut nodes);
        Self { nodes }
    }

    /// Visits what lies within a radius, with the square of its distance, until the visitor has
    /// enough: `false`.
    pub fn around(
        &self,
        center: &[f64; 3],
        radius: f64,
        visitor: &mut impl FnMut(usize, f64) -> bool,
    ) -> bool {
        visit(&self.nodes, center, radius * radius, visitor)
    }
}

fn split(nodes: &mut [Node]) {
    if nodes.len() < 2 {
        return;
    }
    let extent = |i: usize| {
        let along = nodes.iter().map(|node| node.place[i]);
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        high - low
    };
    let extents = [0, 1, 2].map(extent);
    let widest = |a: &usize, b: &usize| extents[*a].total_cmp(&extents[*b]);
    let axis = (0..3).max_by(widest).unwrap_or(0);
    let middle = nodes.len() / 2;
    nodes.select_nth_unstable_by(middle, |a, b| a.place[axis].total_cmp(&b.place[axis]));
    nodes[middle].axis = axis as u8;
    let (lower, upper) = nodes.split_at_mut(middle);
    split(lower);
    split(&mut upper[1..]);
}

fn visit(
    nodes: &[Node],
    center: &[f64; 3],
    squared: f64,
    visitor: &mut impl FnMut(usize, f64) -> bool,
) -> bool {
    let middle = nodes.len() / 2;
    let Some(node) = nodes.get(middle) else {
        return true;
    };
    let off = [0, 1, 2].map(|i| node.place[i] - center[i]);
    let distance = off.iter().map(|x| x * x).sum::<f64>();
    if distance <= squared && !visitor(node.id as usize, distance) {
        return false;
    }
    let across = off[usize::from(node.axis)];
    let (lower, upper) = (&nodes[..middle], &nodes[middle + 1..]);
    let reaches = across * across <= squared;
    (!(across >= 0.0 || reaches) || visit(lower, center, squared, visitor))
        && (!(across <= 0.0 || reaches) || visit(upper, center, squared, visitor))
}
