//! One step along one row of cells: MUSCL-Hancock with the monotonised-central limiter on
//! primitive variables, and the HLLC flux.
//!
//! B. van Leer, Journal of Computational Physics 32 (1979); E. F. Toro, Riemann Solvers and
//! Numerical Methods for Fluid Dynamics, 3rd edition 2009: section 14.4 (the scheme), (10.37)
//! and (10.39) (HLLC); wave speeds of P. Batten, N. Clarke, C. Lambert and D. M. Causon, SIAM
//! Journal on Scientific Computing 18 (1997), which keep density and pressure positive.

/// Density, momentum along and across the row, and total energy, per volume.
pub(in crate::exact) type Conserved = [f64; 4];

/// Cells beside a row, on each side, that the scheme reads and does not advance.
pub(in crate::exact) const GHOSTS: usize = 2;

/// Density, velocity along and across the row, and pressure.
type Primitive = [f64; 4];

/// Volume-specific fields of an ideal gas.
pub(in crate::exact) fn conserved([density, u, v, pressure]: Primitive, gamma: f64) -> Conserved {
    let energy = pressure / (gamma - 1.0) + 0.5 * density * (u * u + v * v);
    [density, density * u, density * v, energy]
}

/// The inverse of [`conserved`].
pub(in crate::exact) fn primitive(q: &Conserved, gamma: f64) -> Primitive {
    let (u, v) = (q[1] / q[0], q[2] / q[0]);
    let pressure = (gamma - 1.0) * (q[3] - 0.5 * (q[1] * u + q[2] * v));
    [q[0], u, v, pressure]
}

/// Velocity along and across the row and sound speed: none if there is no such gas.
pub(in crate::exact) fn speeds(q: &Conserved, gamma: f64) -> Option<[f64; 3]> {
    let [density, u, v, pressure] = primitive(q, gamma);
    let sound = (gamma * pressure / density).sqrt();
    (density > 0.0 && sound.is_finite()).then_some([u.abs(), v.abs(), sound])
}

fn flux(w: &Primitive, q: &Conserved) -> Conserved {
    let [_, u, _, pressure] = *w;
    [q[1], q[1] * u + pressure, q[2] * u, (q[3] + pressure) * u]
}

/// Monotonised central: the smallest of the central and twice the one-sided differences.
fn limited(backward: f64, forward: f64) -> f64 {
    if backward * forward <= 0.0 {
        return 0.0;
    }
    let central = 0.5 * (backward + forward);
    let least = (2.0 * backward.abs()).min(2.0 * forward.abs());
    if central.abs() <= least {
        central
    } else {
        least.copysign(central)
    }
}

/// Both faces of a cell half a step on; the cell's own state where a face would have no
/// positive density or pressure.
fn faces(cells: [&Primitive; 3], ratio: f64, gamma: f64) -> [Primitive; 2] {
    let [before, w, after] = cells;
    let half: Primitive = std::array::from_fn(|i| 0.5 * limited(w[i] - before[i], after[i] - w[i]));
    let left: Primitive = std::array::from_fn(|i| w[i] - half[i]);
    let right: Primitive = std::array::from_fn(|i| w[i] + half[i]);
    let positive = |w: &Primitive| w[0] > 0.0 && w[3] > 0.0;
    if !(positive(&left) && positive(&right)) {
        return [*w; 2];
    }
    let ends = [left, right].map(|w| conserved(w, gamma));
    let (inflow, outflow) = (flux(&left, &ends[0]), flux(&right, &ends[1]));
    let evolved = ends.map(|q| {
        let q: Conserved = std::array::from_fn(|i| q[i] + 0.5 * ratio * (inflow[i] - outflow[i]));
        primitive(&q, gamma)
    });
    if evolved.iter().all(positive) {
        evolved
    } else {
        [*w; 2]
    }
}

/// The flux through a face between two states.
fn hllc(left: &Primitive, right: &Primitive, gamma: f64) -> Conserved {
    let sound = |w: &Primitive| (gamma * w[3] / w[0]).sqrt();
    let [q_left, q_right] = [left, right].map(|w| conserved(*w, gamma));
    // Roe's mean of velocities and enthalpy.
    let roots = [left[0].sqrt(), right[0].sqrt()];
    let mean = |a: f64, b: f64| (roots[0] * a + roots[1] * b) / (roots[0] + roots[1]);
    let (u, v) = (mean(left[1], right[1]), mean(left[2], right[2]));
    let enthalpy = mean(
        (q_left[3] + left[3]) / left[0],
        (q_right[3] + right[3]) / right[0],
    );
    let c = ((gamma - 1.0) * (enthalpy - 0.5 * (u * u + v * v))).max(0.0);
    let c = c.sqrt();
    let slowest = (left[1] - sound(left)).min(u - c);
    let fastest = (right[1] + sound(right)).max(u + c);
    if slowest >= 0.0 {
        return flux(left, &q_left);
    }
    if fastest <= 0.0 {
        return flux(right, &q_right);
    }
    let mass = [
        left[0] * (slowest - left[1]),
        right[0] * (fastest - right[1]),
    ];
    let contact =
        (right[3] - left[3] + left[1] * mass[0] - right[1] * mass[1]) / (mass[0] - mass[1]);
    let (w, q, speed, mass) = if contact >= 0.0 {
        (left, &q_left, slowest, mass[0])
    } else {
        (right, &q_right, fastest, mass[1])
    };
    let density = mass / (speed - contact);
    let energy = q[3] / w[0] + (contact - w[1]) * (contact + w[3] / mass);
    let star = [density, density * contact, density * w[2], density * energy];
    let outside = flux(w, q);
    std::array::from_fn(|i| outside[i] + speed * (star[i] - q[i]))
}

/// Scratch memory of [`advance`].
#[derive(Debug, Clone, Default)]
pub(in crate::exact) struct Scratch {
    cells: Vec<Primitive>,
    faces: Vec<[Primitive; 2]>,
}

/// Advances a row, [`GHOSTS`] filled on either side, by `ratio` = time step / cell size.
pub(in crate::exact) fn advance(
    row: &mut [Conserved],
    ratio: f64,
    gamma: f64,
    scratch: &mut Scratch,
) {
    let Scratch { cells, faces: ends } = scratch;
    cells.clear();
    cells.extend(row.iter().map(|q| primitive(q, gamma)));
    ends.clear();
    ends.extend(
        cells
            .windows(3)
            .map(|w| faces([&w[0], &w[1], &w[2]], ratio, gamma)),
    );
    let inner = row.iter_mut().skip(GHOSTS);
    let mut fluxes = ends.windows(2).map(|e| hllc(&e[0][1], &e[1][0], gamma));
    let Some(mut inflow) = fluxes.next() else {
        return;
    };
    for (q, outflow) in inner.zip(fluxes) {
        for i in 0..4 {
            q[i] += ratio * (inflow[i] - outflow[i]);
        }
        inflow = outflow;
    }
}
