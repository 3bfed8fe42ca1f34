//! Artificial conduction, and whom heat goes to, pair by pair.

use motes_core::cutoff::{CubicSpline, CutOff};
use motes_core::equation::gas::exchange::Extras;
use motes_core::equation::gas::motion::{GasNode, GasSums, Motion};
use motes_core::equation::gas::viscosity::Inviscid;
use motes_core::equation::gas::{Diffusion, Options};
use motes_core::pairs::{Fields, Law, Separation};

type Node = GasNode<f64, Extras<f64, 2>, 2>;

const R: [f64; 2] = [0.6, -0.8];
const CONDUCTION: f64 = 0.75;

/// A particle of width 1.2.
fn node(energy: f64, pressure: f64, sound_speed: f64) -> Node {
    let sigma = CubicSpline.normalisation::<2>();
    Node {
        mass: 1.25,
        measure: 1.25,
        density: 1.5,
        sound_speed,
        terms: Extras {
            specific_volume: 1.0 / 1.5,
            energy,
            pressure,
            ..Extras::ZERO
        },
        epsilon: 1.2,
        gradient: sigma / 1.2f64.powi(4),
        scale: 1.0 / 1.2,
        ..Node::ZERO
    }
}

/// What both receive, `k` the first, at distance 1, with this artificial and physical
/// conduction.
fn heat(k: &Node, l: &Node, conduction: f64, heat: f64) -> [f64; 2] {
    let law = Motion {
        cut_off: CubicSpline,
        viscosity: Inviscid,
        terms: Options {
            conduction,
            diffusion: Diffusion {
                heat,
                ..Diffusion::OFF
            },
            ..Options::OFF
        },
    };
    let (mut to_k, mut to_l) = (GasSums::ZERO, GasSums::ZERO);
    let apart = Separation::of(&law, [k, l], R, 1.0);
    law.pair(k, l, &apart, &mut to_k, &mut to_l);
    [to_k.power, to_l.power]
}

/// Two particles that recede with `speed` along their line of centres, the first one warmer
/// and at a pressure that is higher by `jump`.
fn receding(speed: f64, jump: f64) -> [Node; 2] {
    let (mut k, l) = (node(2.0, 1.0 + jump, 1.1), node(1.6, 1.0, 0.9));
    k.velocity = R.map(|r| speed * r);
    [k, l]
}

#[test]
fn conduction_is_closed_in_a_rarefaction_and_open_at_a_contact_or_shock() {
    let (density, sound_speed) = (1.5, 1.0);
    for speed in [0.05, 0.4] {
        let rarefaction = density * sound_speed * speed;
        for part in [0.0, 0.5, 1.0 - 1e-12] {
            let [k, l] = receding(speed, part * rarefaction);
            let heat = heat(&k, &l, CONDUCTION, 0.0);
            assert_eq!(heat, [0.0; 2], "speed {speed}, {part} of {rarefaction}");
        }
        let [k, l] = receding(speed, 1.01 * rarefaction);
        assert!(heat(&k, &l, CONDUCTION, 0.0)[0] < 0.0);
    }
    // An approach opens it no further than rest: the throttle is one-sided.
    let [k, l] = receding(0.0, 0.3);
    let at_rest = heat(&k, &l, CONDUCTION, 0.0);
    let [k, l] = receding(-0.4, 0.3);
    assert_eq!(heat(&k, &l, CONDUCTION, 0.0), at_rest);
}

/// The formulas of the module's head, with the cut-off's own gradient.
#[test]
fn heat_is_what_the_formulas_say_and_antisymmetric() {
    let (mass, density) = (1.25, 1.5);
    for (speed, jump) in [(0.0, 0.3), (0.1, 0.4), (-0.3, 0.2), (-0.3, 0.0)] {
        let [k, l] = receding(speed, jump);
        let g = k.gradient * CubicSpline.gradient::<2, f64>(1.0 / 1.2);
        let signal = f64::max(jump / density - speed.max(0.0), 0.0).sqrt();
        let artificial =
            mass * mass * CONDUCTION * signal / density * (k.terms.energy - l.terms.energy) * g;
        let physical = mass * mass * 0.2 * (2.0 / density) * (k.terms.energy - l.terms.energy) * g;
        for (conduction, diffusivity, expected) in [
            (CONDUCTION, 0.0, artificial),
            (0.0, 0.2, physical),
            (CONDUCTION, 0.2, artificial + physical),
        ] {
            let [to_k, to_l] = heat(&k, &l, conduction, diffusivity);
            assert_eq!(to_k, -to_l);
            assert!(
                (to_k - expected).abs() <= 1e-14,
                "{to_k}, not {expected}: speed {speed}, jump {jump}"
            );
            // Downhill.
            assert!(to_k <= 0.0);
        }
    }
}

#[test]
fn no_heat_crosses_between_materials() {
    for [a, b] in [[0.0, 1.0], [1.0, 0.0], [2.0, 255.0]] {
        let [mut k, mut l] = receding(-0.2, 0.5);
        (k.terms.material, l.terms.material) = (a, b);
        assert_eq!(heat(&k, &l, CONDUCTION, 0.2), [0.0; 2], "{a} and {b}");
        l.terms.material = a;
        assert!(heat(&k, &l, CONDUCTION, 0.2)[0] < 0.0, "{a} and {a}");
    }
}

/// A linear profile of energy is no jump; a jump seen on a flat background is whole; and
/// slopes too steep for the jump do not turn the flow round.
#[test]
fn conduction_spares_a_linear_profile_and_never_runs_uphill() {
    let [mut k, mut l] = receding(0.0, 0.5);
    let whole = heat(&k, &l, CONDUCTION, 0.0)[0];
    let slope = |rise: f64| R.map(|r| rise * r);
    let jump = k.terms.energy - l.terms.energy;
    for (rise, part) in [(0.0, 1.0), (0.5, 0.5), (1.0, 0.0), (2.0, 0.0), (-1.0, 1.0)] {
        (k.terms.energy_slope, l.terms.energy_slope) = (slope(rise * jump), slope(rise * jump));
        let [to_k, to_l] = heat(&k, &l, CONDUCTION, 0.0);
        assert_eq!(to_k, -to_l);
        assert!(
            (to_k - part * whole).abs() < 1e-15,
            "slope {rise}: {to_k} of {whole}, expected {part}"
        );
    }
    // Slopes of unlike sign: an extremum, where nothing is continued.
    (k.terms.energy_slope, l.terms.energy_slope) = (slope(jump), slope(-jump));
    assert_eq!(heat(&k, &l, CONDUCTION, 0.0)[0], whole);
}
