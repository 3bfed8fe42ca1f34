//! Particles in one place.
//!
//! Two particles in one place are one of twice the mass that counts as two, and no width of a cut-off
//! tells them apart: most often a file was joined to itself, or both ends of a period were given.

/// Where particles are: a box, of which some directions close on themselves.
#[derive(Clone, Copy, Debug)]
pub struct Room {
    /// Its lower corner.
    pub lower: [f64; 3],
    /// Its lengths; 0 beyond the dimension.
    pub lengths: [f64; 3],
    /// Which directions are periodic.
    pub periodic: [bool; 3],
}

impl Room {
    /// A place as it is written.
    pub fn shown(&self, position: &[f64; 3]) -> String {
        let dimension = self.lengths.iter().filter(|&&length| length > 0.0).count();
        match &position[..dimension.max(1)] {
            [x] => format!("{x}"),
            more => {
                let parts: Vec<String> = more.iter().map(f64::to_string).collect();
                format!("({})", parts.join(", "))
            }
        }
    }
}

/// Two particles in one place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coincidence {
    /// The one with the lower id.
    pub first: usize,
    /// The other: the lowest id of all that lie where one before lies.
    pub second: usize,
    /// How many lie where one before lies.
    pub count: usize,
}

/// The part of the mean spacing of a cloud below which two places are one.
pub const SAME_PLACE: f64 = 1e-6;

/// The mean spacing of a cloud in the box that it fills; that of the room where it has no size.
pub fn mean_spacing(positions: &[[f64; 3]], room: &Room) -> f64 {
    let dimension = room.lengths.iter().filter(|&&length| length > 0.0).count();
    let size = |i: usize| {
        let along = positions.iter().map(|x| x[i]);
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        high - low
    };
    let sizes: [f64; 3] = std::array::from_fn(|i| if i < dimension { size(i) } else { 0.0 });
    let longest = sizes.iter().copied().fold(0.0, f64::max);
    let sizes = if longest > 0.0 { sizes } else { room.lengths };
    let longest = sizes.iter().copied().fold(0.0, f64::max);
    let count = positions.len().max(1) as f64;
    // A row of particles is as thin as one of them.
    let volume: f64 = sizes[..dimension]
        .iter()
        .map(|size| size.max(longest / count))
        .product();
    libm::pow(volume / count, 1.0 / dimension.max(1) as f64)
}

/// The first two particles no farther apart than `tolerance`, through periodic sides too; `O(N log
/// N)`.
pub fn coincidence(positions: &[[f64; 3]], room: &Room, tolerance: f64) -> Option<Coincidence> {
    // Cells so small that two in one are suspicious, and so wide that few touch more than one.
    let cell = 64.0 * tolerance;
    let mut entries = Vec::with_capacity(positions.len());
    for (id, position) in positions.iter().enumerate() {
        for place in images(position, room, tolerance) {
            let key = |i: usize, off: f64| ((place[i] + off) / cell).floor() as i64;
            let [low, high] = [-tolerance, tolerance].map(|off| [0, 1, 2].map(|i| key(i, off)));
            for x in low[0]..=high[0] {
                for y in low[1]..=high[1] {
                    for z in low[2]..=high[2] {
                        entries.push(([x, y, z], place, id));
                    }
                }
            }
        }
    }
    entries.sort_unstable_by(|a, b| {
        let along = || a.1[0].total_cmp(&b.1[0]);
        a.0.cmp(&b.0).then_with(along).then_with(|| a.2.cmp(&b.2))
    });
    let mut pairs: Vec<[usize; 2]> = Vec::new();
    for (place, (key, x, id)) in entries.iter().enumerate() {
        let before = entries[..place].iter().rev();
        let near = before.take_while(|(other, y, _)| other == key && x[0] - y[0] <= tolerance);
        let twin = near.filter(|(_, y, other)| other != id && distance(x, y) <= tolerance);
        pairs.extend(
            twin.take(1)
                .map(|(.., other)| [*id.max(other), *id.min(other)]),
        );
    }
    pairs.sort_unstable();
    pairs.dedup_by_key(|pair| pair[0]);
    let &[second, first] = pairs.first()?;
    Some(Coincidence {
        first,
        second,
        count: pairs.len(),
    })
}

/// A place from the lower corner, and once more one period lower where it lies at an upper periodic
/// side.
fn images(position: &[f64; 3], room: &Room, tolerance: f64) -> Vec<[f64; 3]> {
    let inside: [f64; 3] = std::array::from_fn(|i| position[i] - room.lower[i]);
    let mut images = vec![inside];
    for i in 0..3 {
        if room.periodic[i] && inside[i] >= room.lengths[i] - 2.0 * tolerance {
            for place in 0..images.len() {
                let mut image = images[place];
                image[i] -= room.lengths[i];
                images.push(image);
            }
        }
    }
    images
}

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}
