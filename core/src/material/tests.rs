//! Sound speeds are those of thermodynamics: `c² = ∂p/∂ρ + p/ρ² ∂p/∂e`.

use super::*;

fn laws() -> [Named<f64>; 4] {
    [
        Named::IdealGas(IdealGas::new(1.4)),
        Named::StiffenedGas(StiffenedGas::new(4.4, 6.0)),
        Named::Isothermal(Isothermal::new(0.7)),
        Named::Tait(Tait::new(0.9, 3.0, 7)),
    ]
}

#[test]
fn the_sound_speed_is_the_adiabatic_derivative_of_the_pressure() {
    for law in laws() {
        for (density, energy) in [(1.0, 9.0), (0.8, 25.0), (1.3, 12.0)] {
            let h = 1e-5;
            let by_density =
                (law.pressure(density + h, energy) - law.pressure(density - h, energy)) / (2.0 * h);
            let by_energy =
                (law.pressure(density, energy + h) - law.pressure(density, energy - h)) / (2.0 * h);
            let expected =
                by_density + law.pressure(density, energy) / density / density * by_energy;
            let c = law.sound_speed(density, energy);
            assert!(
                (c * c - expected).abs() < 1e-7 * expected.abs(),
                "{law:?}: c² = {} instead of {expected}",
                c * c
            );
        }
    }
}

#[test]
fn a_stiffened_gas_without_stiffness_is_an_ideal_gas() {
    let (stiffened, ideal) = (
        StiffenedGas::<f64>::new(1.4, 0.0),
        IdealGas::<f64>::new(1.4),
    );
    assert_eq!(stiffened.pressure(0.7, 2.1), ideal.pressure(0.7, 2.1));
    let [a, b] = [stiffened.sound_speed(0.7, 2.1), ideal.sound_speed(0.7, 2.1)];
    assert!((a - b).abs() < 1e-15);
}

#[test]
fn a_liquid_at_rest_has_no_pressure() {
    assert_eq!(Tait::<f64>::new(0.5, 3.0, 7).pressure(0.5, 1.0), 0.0);
}

#[test]
fn sound_does_not_travel_where_its_speed_would_be_imaginary() {
    assert_eq!(IdealGas::<f64>::new(1.4).sound_speed(1.0, -1.0), 0.0);
    assert_eq!(
        StiffenedGas::<f64>::new(1.4, 1.0).sound_speed(1.0, -9.0),
        0.0
    );
}

/// An expansion in many steps, each of a few last places, follows the isentrope.
#[cfg(feature = "fixed")]
#[test]
fn small_steps_in_fixed_point_add_up_to_the_isentrope() {
    use crate::scalar::{Q32, Scalar};
    use fixed::types::extra::U19;
    type Q = Q32<U19>;
    const STEPS: u32 = 20_000;
    let place = |step: u32| 1.0 - 0.425 * f64::from(step) / f64::from(STEPS);
    let laws = [
        Named::<Q>::IdealGas(IdealGas::new(1.4)),
        Named::StiffenedGas(StiffenedGas::new(1.4, 0.0)),
    ];
    for law in laws {
        for ends in [[0, STEPS], [STEPS, 0]] {
            let energy = |step: u32| 3.0 * libm::pow(place(step), 0.4);
            let mut found = Q::from_f64(energy(ends[0]));
            for step in 1..=STEPS {
                let at = |step: u32| Q::from_f64(place(ends[0].abs_diff(step)));
                found = law.compressed([at(step - 1), at(step)], found);
            }
            let off = found.to_f64() / energy(ends[1]) - 1.0;
            assert!(off.abs() < 1.5e-3, "{law:?}, {ends:?}: {off}");
        }
    }
}
