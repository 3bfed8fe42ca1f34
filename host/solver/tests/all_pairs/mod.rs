//! The reference: gas dynamics as section 1 of the design prints it, summed over all pairs.
//!
//! It shares no arithmetic with the core, only names and `f64` data: the cut-offs are the
//! piecewise polynomials of the textbooks, gradients are vectors, images are particles that
//! have been moved and reflected, ε is found by bisection and Ω from its definition.

use std::f64::consts::PI;

use motes_core::cutoff::Named;
use motes_core::domain::{Axis, Side};
use motes_core::equation::gas::{Packing, Weights, Width};

pub type Vector<const D: usize> = [f64; D];

pub fn dot<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub fn length<const D: usize>(a: &Vector<D>) -> f64 {
    dot(a, a).sqrt()
}

/// `Σ c_i q^i` and its derivative.
fn polynomial(coefficients: &[f64], q: f64) -> (f64, f64) {
    let horner = |(value, slope), c| (value * q + c, slope * q + value);
    coefficients.iter().rev().fold((0.0, 0.0), horner)
}

/// `Σ c (edge - q)^n` over `(c, edge)` and its derivative: one piece of a B-spline.
fn spline(n: i32, terms: &[(f64, f64)], q: f64) -> (f64, f64) {
    let power = |n| move |&(c, edge): &(f64, f64)| c * (edge - q).powi(n);
    let value: f64 = terms.iter().map(power(n)).sum();
    let slope: f64 = terms.iter().map(power(n - 1)).sum();
    (value, -f64::from(n) * slope)
}

/// `(1 - q/2)^n p(q)` and its derivative.
fn wendland(n: i32, p: &[f64], q: f64) -> (f64, f64) {
    let t = 1.0 - 0.5 * q;
    let (p, slope) = polynomial(p, q);
    let factor = -0.5 * f64::from(n) * t.powi(n - 1);
    (t.powi(n) * p, factor * p + t.powi(n) * slope)
}

/// Radius of the support in units of ε.
pub fn support(cut_off: Named) -> f64 {
    match cut_off {
        Named::RootFree => 1.0,
        Named::QuinticSpline | Named::SmoothTwo => 3.0,
        _ => 2.0,
    }
}

/// `σ z(q)` and `σ z'(q)`: M4 and M6 as in Monaghan & Lattanzio (1985) and Morris (1996),
/// Wendland's as in Dehnen & Aly (2012) for a support of 2, `(1-q²)^4` and `(1-q²/9)^7`.
pub fn shape<const D: usize>(cut_off: Named, q: f64) -> (f64, f64) {
    if q >= support(cut_off) {
        return (0.0, 0.0);
    }
    let line = D == 1;
    let (sigma, (value, slope)) = match cut_off {
        Named::CubicSpline => (
            [2.0 / 3.0, 10.0 / (7.0 * PI), 1.0 / PI],
            match q {
                0.0..1.0 => polynomial(&[1.0, 0.0, -1.5, 0.75], q),
                _ => spline(3, &[(0.25, 2.0)], q),
            },
        ),
        Named::QuinticSpline => (
            [1.0 / 120.0, 7.0 / (478.0 * PI), 1.0 / (120.0 * PI)],
            match q {
                0.0..1.0 => spline(5, &[(1.0, 3.0), (-6.0, 2.0), (15.0, 1.0)], q),
                1.0..2.0 => spline(5, &[(1.0, 3.0), (-6.0, 2.0)], q),
                _ => spline(5, &[(1.0, 3.0)], q),
            },
        ),
        Named::WendlandC2 => (
            [5.0 / 8.0, 7.0 / (4.0 * PI), 21.0 / (16.0 * PI)],
            match line {
                true => wendland(3, &[1.0, 1.5], q),
                false => wendland(4, &[1.0, 2.0], q),
            },
        ),
        Named::WendlandC4 => (
            [3.0 / 4.0, 9.0 / (4.0 * PI), 495.0 / (256.0 * PI)],
            match line {
                true => wendland(5, &[1.0, 2.5, 2.0], q),
                false => wendland(6, &[1.0, 3.0, 35.0 / 12.0], q),
            },
        ),
        Named::WendlandC6 => (
            [55.0 / 64.0, 78.0 / (28.0 * PI), 1365.0 / (512.0 * PI)],
            match line {
                true => wendland(7, &[1.0, 3.5, 19.0 / 4.0, 21.0 / 8.0], q),
                false => wendland(8, &[1.0, 4.0, 25.0 / 4.0, 4.0], q),
            },
        ),
        Named::RootFree => ([315.0 / 256.0, 5.0 / PI, 3465.0 / (512.0 * PI)], {
            let t = 1.0 - q * q;
            (t.powi(4), -8.0 * q * t.powi(3))
        }),
        // 1/σ is 3^D times the integral of (1-q²)^7 over the unit ball.
        Named::SmoothTwo => (
            [
                6435.0 / 12288.0,
                8.0 / (9.0 * PI),
                11_486_475.0 / (23_224_320.0 * PI),
            ],
            {
                let t = 1.0 - q * q / 9.0;
                (t.powi(7), -14.0 / 9.0 * q * t.powi(6))
            },
        ),
        Named::QuinticSplineFour | Named::SmoothFour | Named::SmoothSix => {
            panic!("{cut_off:?} is below 0 somewhere: no gas has it")
        }
    };
    (sigma[D - 1] * value, sigma[D - 1] * slope)
}

/// `εⁿ`.
fn power(epsilon: f64, n: usize) -> f64 {
    (0..n).map(|_| epsilon).product()
}

/// `ζ_ε(r) = ε^-D σ z(|r|/ε)`.
pub fn zeta<const D: usize>(cut_off: Named, distance: f64, epsilon: f64) -> f64 {
    shape::<D>(cut_off, distance / epsilon).0 / power(epsilon, D)
}

/// `∂ζ_ε/∂ε = -ε^-(D+1) σ (D z + q z')`.
pub fn zeta_by_epsilon<const D: usize>(cut_off: Named, distance: f64, epsilon: f64) -> f64 {
    let q = distance / epsilon;
    let (value, slope) = shape::<D>(cut_off, q);
    -(D as f64 * value + q * slope) / power(epsilon, D + 1)
}

/// `∇ζ_ε(r) = ε^-(D+1) σ z'(|r|/ε) r/|r|`; 0 at `r = 0`.
pub fn gradient<const D: usize>(cut_off: Named, r: &Vector<D>, epsilon: f64) -> Vector<D> {
    let distance = length(r);
    if distance == 0.0 {
        return [0.0; D];
    }
    let slope = shape::<D>(cut_off, distance / epsilon).1 / power(epsilon, D + 1);
    r.map(|x| slope * x / distance)
}

/// The pseudo-viscosities of the design.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Viscosity {
    Inviscid,
    VonNeumann,
    GingoldMonaghan,
    Pairwise,
}

/// A particle as it is put in.
#[derive(Clone, Copy, Debug)]
pub struct Body<const D: usize> {
    pub position: Vector<D>,
    pub velocity: Vector<D>,
    pub mass: f64,
    pub energy: f64,
}

/// What comes out for it.
#[derive(Clone, Debug)]
pub struct Found<const D: usize> {
    pub epsilon: f64,
    pub density: f64,
    /// ν: ρ, or the number of particles per volume.
    pub sum: f64,
    pub omega: f64,
    /// `div u`.
    pub divergence: f64,
    /// `m du/dt`.
    pub force: Vector<D>,
    /// `m de/dt`.
    pub power: f64,
    /// What viscosity gives of it.
    pub heat: f64,
    /// The sums of the absolute values of the terms of the last three: what rounding errors
    /// are proportional to.
    pub divergence_terms: f64,
    pub force_terms: f64,
    pub power_terms: f64,
    /// First and second derivative of Ω by ln ε over Ω: the largest differences within two
    /// steps of [`Problem::probe`]. They say how well Ω can be extrapolated.
    pub bend: [f64; 2],
    /// All particles and images but itself with their distances, at least up to its support.
    pub partners: Vec<(usize, f64)>,
}

/// How a particle is seen along each direction: `x → sign x + shift`, `u → sign u`.
#[derive(Clone, Copy)]
struct Image<const D: usize> {
    sign: Vector<D>,
    shift: Vector<D>,
}

/// A particle or an image `l` seen from `k`.
#[derive(Clone)]
struct Seen<const D: usize> {
    l: usize,
    itself: bool,
    /// `x_k - x_l`.
    r: Vector<D>,
    distance: f64,
    /// `u_k - u_l`.
    u: Vector<D>,
}

/// What is known of a particle when the pair terms are summed.
struct Node {
    mass: f64,
    measure: f64,
    epsilon: f64,
    density: f64,
    sound_speed: f64,
    /// `(p + q)/(Ω ν²)`.
    pressure: f64,
    /// `q/(Ω ν²)`.
    viscous: f64,
}

/// A gas and its laws.
#[derive(Clone, Debug)]
pub struct Problem<const D: usize> {
    pub axes: [Axis<f64>; D],
    pub cut_off: Named,
    pub width: Width<f64>,
    pub weights: Weights,
    pub viscosity: Viscosity,
    pub alpha: f64,
    pub beta: f64,
    pub gamma: f64,
    /// A step in ln ε, for [`Found::bend`].
    pub probe: f64,
}

impl<const D: usize> Problem<D> {
    /// What a particle counts as in sums: its mass, or 1.
    fn measure(&self, body: &Body<D>) -> f64 {
        match self.weights {
            Weights::Mass => body.mass,
            Weights::Number => 1.0,
        }
    }

    /// Density, Ω and rates of every particle.
    pub fn solve(&self, bodies: &[Body<D>]) -> Vec<Found<D>> {
        let (seen, epsilons) = self.settle(bodies);
        let mut found: Vec<Found<D>> = (seen.iter().zip(&epsilons))
            .zip(bodies)
            .map(|((seen, &epsilon), body)| self.at_rest(body, seen, epsilon, bodies))
            .collect();
        let nodes: Vec<Node> = (found.iter().zip(bodies))
            .map(|(found, body)| self.node(found, body))
            .collect();
        for (k, (found, seen)) in found.iter_mut().zip(&seen).enumerate() {
            self.rates(k, &nodes, seen, found);
        }
        found
    }

    /// All combinations of periodic shifts and mirror reflections, the particle itself first.
    fn images(&self) -> Vec<Image<D>> {
        let mut images = vec![Image {
            sign: [1.0; D],
            shift: [0.0; D],
        }];
        for (i, axis) in self.axes.iter().enumerate() {
            let period = axis.upper - axis.lower;
            let mut seen = Vec::new();
            match axis.sides {
                [Side::Periodic, Side::Periodic] => seen.extend([(1.0, -period), (1.0, period)]),
                [lower, upper] => {
                    if lower == Side::Mirror {
                        seen.push((-1.0, 2.0 * axis.lower));
                    }
                    if upper == Side::Mirror {
                        seen.push((-1.0, 2.0 * axis.upper));
                    }
                }
            }
            for image in images.clone() {
                for &(sign, shift) in &seen {
                    let mut image = image;
                    (image.sign[i], image.shift[i]) = (sign, shift);
                    images.push(image);
                }
            }
        }
        images
    }

    /// Everything within `radius` of particle `k`.
    fn seen(&self, k: usize, bodies: &[Body<D>], images: &[Image<D>], radius: f64) -> Vec<Seen<D>> {
        let mut all = Vec::new();
        let from = &bodies[k];
        for (l, body) in bodies.iter().enumerate() {
            for (number, image) in images.iter().enumerate() {
                let place: Vector<D> =
                    std::array::from_fn(|i| image.sign[i] * body.position[i] + image.shift[i]);
                let r: Vector<D> = std::array::from_fn(|i| from.position[i] - place[i]);
                let distance = length(&r);
                if distance < radius {
                    let u = std::array::from_fn(|i| {
                        from.velocity[i] - image.sign[i] * body.velocity[i]
                    });
                    let itself = l == k && number == 0;
                    all.push(Seen {
                        l,
                        itself,
                        r,
                        distance,
                        u,
                    });
                }
            }
        }
        all
    }

    /// What every particle sees, at least up to the largest support of all, and every ε.
    fn settle(&self, bodies: &[Body<D>]) -> (Vec<Vec<Seen<D>>>, Vec<f64>) {
        let images = self.images();
        let mut largest = match self.width {
            Width::Constant { epsilon } => epsilon,
            Width::Adaptive { eta, .. } => 2.0 * eta,
        };
        loop {
            // An image behind an image is nowhere made.
            let radius = largest * support(self.cut_off);
            let room = |axis: &Axis<f64>| {
                axis.sides.contains(&Side::Free) || axis.upper - axis.lower > radius
            };
            assert!(
                self.axes.iter().all(room),
                "reach {radius} in {:?}",
                self.axes
            );
            let seen: Vec<_> = (0..bodies.len())
                .map(|k| self.seen(k, bodies, &images, radius))
                .collect();
            let epsilons: Option<Vec<f64>> = (seen.iter().zip(bodies))
                .map(|(seen, body)| self.epsilon(seen, bodies, self.measure(body), largest))
                .collect();
            match epsilons {
                Some(epsilons) => return (seen, epsilons),
                None => largest *= 1.25,
            }
        }
    }

    /// `ε = η (μ/ν(ε))^(1/D)`, by bisection of the monotone `ν(ε) ε^D - μ η^D` below `largest`.
    fn epsilon(
        &self,
        seen: &[Seen<D>],
        bodies: &[Body<D>],
        measure: f64,
        largest: f64,
    ) -> Option<f64> {
        let eta = match self.width {
            Width::Constant { epsilon } => return Some(epsilon),
            Width::Adaptive { eta, .. } => eta,
        };
        let too_wide = |epsilon: f64| {
            self.sum(seen, bodies, epsilon, measure) * power(epsilon, D) > measure * power(eta, D)
        };
        let (mut low, mut high) = (0.0, largest);
        if !too_wide(high) {
            return None;
        }
        while high - low > 1e-15 * high {
            let middle = 0.5 * (low + high);
            match too_wide(middle) {
                true => high = middle,
                false => low = middle,
            }
        }
        Some(high)
    }

    /// By how much a cubic lattice of spacing 1 is too dense at `ε = η`, and η; 0 where ε is the same
    /// for all.
    fn excess(&self) -> (f64, f64) {
        let Width::Adaptive { eta, packing } = self.width else {
            return (0.0, 1.0);
        };
        assert_eq!(packing, Packing::Cubic);
        let most = (support(self.cut_off) * eta).ceil() as i32;
        let along = |i: usize| if i < D { -most..=most } else { 0..=0 };
        let mut density = 0.0;
        for x in along(0) {
            for y in along(1) {
                for z in along(2) {
                    let distance = f64::from(x * x + y * y + z * z).sqrt();
                    density += zeta::<D>(self.cut_off, distance, eta);
                }
            }
        }
        (density - 1.0, eta)
    }

    /// `ν(ε) = Σ_l μ_l ζ_ε(x_k - x_l) - E μ_k (η/ε)^D`, E the excess of a lattice.
    fn sum(&self, seen: &[Seen<D>], bodies: &[Body<D>], epsilon: f64, measure: f64) -> f64 {
        let zeta = |s: &Seen<D>| zeta::<D>(self.cut_off, s.distance, epsilon);
        let term = |s: &Seen<D>| self.measure(&bodies[s.l]) * zeta(s);
        let (excess, eta) = self.excess();
        seen.iter().map(term).sum::<f64>() - excess * measure * power(eta / epsilon, D)
    }

    /// `∂ν/∂ε`.
    fn by_epsilon(&self, seen: &[Seen<D>], epsilon: f64, bodies: &[Body<D>], measure: f64) -> f64 {
        let term = |s: &Seen<D>| {
            self.measure(&bodies[s.l]) * zeta_by_epsilon::<D>(self.cut_off, s.distance, epsilon)
        };
        let (excess, eta) = self.excess();
        let own = excess * measure * power(eta / epsilon, D) * D as f64 / epsilon;
        seen.iter().map(term).sum::<f64>() + own
    }

    /// See [`Found::bend`]. Beside the solution, Ω is `∂(ν ε^D)/∂ ln ε / (D ν ε^D)` with the
    /// ν ε^D of the solution.
    fn bend(&self, seen: &[Seen<D>], epsilon: f64, bodies: &[Body<D>], measure: f64) -> [f64; 2] {
        if let Width::Constant { .. } = self.width {
            return [0.0; 2];
        }
        let omegas = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|steps| {
            let epsilon = epsilon * f64::exp(steps * self.probe);
            let sum = self.sum(seen, bodies, epsilon, measure);
            let slope = sum + epsilon / D as f64 * self.by_epsilon(seen, epsilon, bodies, measure);
            power(epsilon, D) * slope
        });
        let largest =
            |differences: [f64; 3]| differences.map(f64::abs).into_iter().fold(0.0, f64::max);
        let first = largest([0, 1, 2].map(|i| 0.5 * (omegas[i + 2] - omegas[i])));
        let second = largest([0, 1, 2].map(|i| omegas[i] - 2.0 * omegas[i + 1] + omegas[i + 2]));
        [
            first / (self.probe * omegas[2]),
            second / (self.probe * self.probe * omegas[2]),
        ]
    }

    /// ν, `ρ = m ν/μ`, Ω and div u of a body.
    fn at_rest(
        &self,
        body: &Body<D>,
        seen: &[Seen<D>],
        epsilon: f64,
        bodies: &[Body<D>],
    ) -> Found<D> {
        let measure = self.measure(body);
        let nu = self.sum(seen, bodies, epsilon, measure);
        let omega = match self.width {
            Width::Constant { .. } => 1.0,
            Width::Adaptive { .. } => {
                1.0 + epsilon / (D as f64 * nu) * self.by_epsilon(seen, epsilon, bodies, measure)
            }
        };
        let (mut sum, mut terms) = (0.0, 0.0);
        for s in seen {
            let gradient = gradient(self.cut_off, &s.r, epsilon);
            let measure = self.measure(&bodies[s.l]);
            sum += measure * dot(&s.u, &gradient);
            terms += measure * length(&s.u) * length(&gradient);
        }
        Found {
            epsilon,
            density: match self.weights {
                Weights::Mass => nu,
                Weights::Number => body.mass * nu,
            },
            sum: nu,
            omega,
            divergence: -sum / (nu * omega),
            divergence_terms: terms / (nu * omega),
            force: [0.0; D],
            force_terms: 0.0,
            power: 0.0,
            heat: 0.0,
            power_terms: 0.0,
            bend: self.bend(seen, epsilon, bodies, measure),
            partners: seen
                .iter()
                .filter(|s| !s.itself)
                .map(|s| (s.l, s.distance))
                .collect(),
        }
    }

    /// `p = (γ-1) ρ e`, `c² = γ (γ-1) e`, and the paper's `q` beside `p`.
    fn node(&self, found: &Found<D>, body: &Body<D>) -> Node {
        let (epsilon, density, divergence) = (found.epsilon, found.density, found.divergence);
        let pressure = (self.gamma - 1.0) * density * body.energy;
        let mut viscous = 0.0;
        let sound_speed = (self.gamma * (self.gamma - 1.0) * body.energy).sqrt();
        if self.viscosity == Viscosity::VonNeumann && divergence < 0.0 {
            let linear = -self.alpha * epsilon * sound_speed * divergence;
            let quadratic = self.beta * epsilon * epsilon * divergence * divergence;
            viscous = density * (linear + quadratic);
        }
        Node {
            mass: body.mass,
            measure: self.measure(body),
            epsilon,
            density,
            sound_speed,
            pressure: (pressure + viscous) / (found.omega * found.sum * found.sum),
            viscous: viscous / (found.omega * found.sum * found.sum),
        }
    }

    /// `Π_kl`.
    fn pi(&self, k: &Node, l: &Node, s: &Seen<D>) -> f64 {
        if s.distance == 0.0 {
            return 0.0;
        }
        // The speed along the line of centres, negative where the pair approaches.
        let speed = dot(&s.u, &s.r) / s.distance;
        if speed >= 0.0 {
            return 0.0;
        }
        let sound_speed = 0.5 * (k.sound_speed + l.sound_speed);
        let density = 0.5 * (k.density + l.density);
        match self.viscosity {
            Viscosity::Inviscid | Viscosity::VonNeumann => 0.0,
            Viscosity::Pairwise => {
                -(self.alpha * sound_speed - self.beta * speed / 2.0) * speed / density
            }
            Viscosity::GingoldMonaghan => {
                let epsilon = 0.5 * (k.epsilon + l.epsilon);
                let softened = s.distance * s.distance + 0.01 * epsilon * epsilon;
                let mu = epsilon * speed * s.distance / softened;
                (-self.alpha * sound_speed * mu + self.beta * mu * mu) / density
            }
        }
    }

    /// `m du/dt` and `m de/dt`.
    fn rates(&self, k: usize, nodes: &[Node], seen: &[Seen<D>], found: &mut Found<D>) {
        let node = &nodes[k];
        for s in seen {
            let partner = &nodes[s.l];
            let at_k = gradient(self.cut_off, &s.r, node.epsilon);
            let at_l = gradient(self.cut_off, &s.r, partner.epsilon);
            let mean: Vector<D> = std::array::from_fn(|i| 0.5 * (at_k[i] + at_l[i]));
            let pi = self.pi(node, partner, s);
            let masses = node.mass * partner.mass;
            let measures = node.measure * partner.measure;
            for i in 0..D {
                let pressures = node.pressure * at_k[i] + partner.pressure * at_l[i];
                found.force[i] -= measures * pressures + masses * pi * mean[i];
            }
            found.power += measures * node.pressure * dot(&s.u, &at_k);
            found.power += 0.5 * masses * pi * dot(&s.u, &mean);
            found.heat += measures * node.viscous * dot(&s.u, &at_k);
            found.heat += 0.5 * masses * pi * dot(&s.u, &mean);

            let pressures = node.pressure * length(&at_k) + partner.pressure * length(&at_l);
            let friction = masses * pi.abs() * length(&mean);
            found.force_terms += measures * pressures + friction;
            let works = measures * node.pressure * length(&at_k) + 0.5 * friction;
            found.power_terms += length(&s.u) * works;
        }
    }

    /// Kick, drift, kick: one step from `bodies` with the rates `found` there; returns the
    /// rates at the end, and which particles went through a side or off a wall.
    pub fn advance(&self, bodies: &mut [Body<D>], found: &[Found<D>], dt: f64) -> Step<D> {
        let mut accelerations: Vec<Vector<D>> = found
            .iter()
            .zip(bodies.iter())
            .map(|(f, b)| f.force.map(|f| f / b.mass))
            .collect();
        let heating: Vec<f64> = found
            .iter()
            .zip(bodies.iter())
            .map(|(f, b)| f.heat / b.mass)
            .collect();
        let (mut wrapped, mut bounced) = (Vec::new(), Vec::new());
        for (k, (body, a)) in bodies.iter_mut().zip(&mut accelerations).enumerate() {
            for i in 0..D {
                let axis = &self.axes[i];
                // u^(n+1/2) = u^n + dt/2 a^n, x^(n+1) = x^n + dt u^(n+1/2).
                let mut x = body.position[i] + dt * (body.velocity[i] + 0.5 * dt * a[i]);
                for (end, at) in [axis.lower, axis.upper].into_iter().enumerate() {
                    let inwards = 1.0 - 2.0 * end as f64;
                    if inwards * (x - at) >= 0.0 {
                        continue;
                    }
                    match axis.sides[end] {
                        Side::Free | Side::Inflow | Side::Outflow => {}
                        Side::Periodic => {
                            x += inwards * (axis.upper - axis.lower);
                            wrapped.push(k);
                        }
                        // It becomes its own mirror image.
                        Side::Mirror => {
                            x = 2.0 * at - x;
                            body.velocity[i] *= -1.0;
                            a[i] *= -1.0;
                            bounced.push(k);
                        }
                    }
                }
                body.position[i] = x;
            }
        }
        let mut predicted: Vec<Body<D>> = (bodies.iter().zip(&accelerations))
            .map(|(body, a)| Body {
                velocity: std::array::from_fn(|i| body.velocity[i] + dt * a[i]),
                ..*body
            })
            .collect();
        // Densities do not depend on energies: heat, compress, heat; by the share of the heat the work of
        // the forces instead.
        let start: Vec<f64> = bodies.iter().map(|body| body.energy).collect();
        let first = found;
        let densities = self.solve(&predicted);
        for (k, body) in bodies.iter_mut().enumerate() {
            let ratio = densities[k].density / first[k].density;
            body.energy = (body.energy + 0.5 * dt * heating[k]) * ratio.powf(self.gamma - 1.0);
            predicted[k].energy = (body.energy + 0.5 * dt * heating[k]).max(0.0);
        }
        let found = self.solve(&predicted);
        for (k, body) in bodies.iter_mut().enumerate() {
            for i in 0..D {
                let end = found[k].force[i] / body.mass;
                body.velocity[i] += 0.5 * dt * (accelerations[k][i] + end);
            }
            body.energy += 0.5 * dt * found[k].heat / body.mass;
            let ends = [&first[k], &found[k]];
            let heat: f64 = ends.iter().map(|end| end.heat.abs()).sum();
            let rest: f64 = ends.iter().map(|end| (end.power - end.heat).abs()).sum();
            if heat > 0.0 {
                let work: f64 = ends.iter().map(|end| end.power).sum();
                let by_work = start[k] + 0.5 * dt * work / body.mass;
                body.energy += (4.0 * heat / (heat + rest)).min(1.0) * (by_work - body.energy);
            }
        }
        Step {
            found,
            wrapped,
            bounced,
        }
    }
}

/// What a step leaves beside the particles.
pub struct Step<const D: usize> {
    pub found: Vec<Found<D>>,
    /// Who went through a periodic side.
    pub wrapped: Vec<usize>,
    /// Who met a wall.
    pub bounced: Vec<usize>,
}
