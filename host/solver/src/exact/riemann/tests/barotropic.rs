//! Isothermal gases and liquids after Tait: closed solutions, jump conditions, fans, mixed tubes.

use super::*;
use crate::exact::riemann::between;
use crate::scenario::EquationOfState;

const ISOTHERMAL: EquationOfState = EquationOfState::Isothermal { sound_speed: 2.0 };
const LIQUID: EquationOfState = EquationOfState::Tait {
    density: 1.5,
    sound_speed: 4.0,
    exponent: 7,
};
/// `p = c² (rho - rho_0)`: linear, as with the exponent 1.
const LINEAR: EquationOfState = EquationOfState::Tait {
    density: 1.5,
    sound_speed: 4.0,
    exponent: 1,
};
const AIR: EquationOfState = EquationOfState::IdealGas { gamma: 1.4 };

fn state(law: &EquationOfState, density: f64, velocity: f64) -> GasState {
    GasState {
        density,
        velocity,
        pressure: law.pressure(density, 0.0),
    }
}

fn tube(law: EquationOfState, left: [f64; 2], right: [f64; 2]) -> RiemannSolution {
    let side = |[density, velocity]: [f64; 2]| (state(&law, density, velocity), law);
    between(side(left), side(right)).unwrap()
}

/// Two streams of the same gas that meet at `±u`: with the isothermal jump `u/c = √r - 1/√r`, r the
/// ratio of the densities, a quadratic for √r. Streams that part leave `rho exp(-u/c)`.
#[test]
fn isothermal_streams_have_the_densities_of_the_closed_solution() {
    for mach in [1e-6, 0.1, 1.0, 5.0] {
        let u = 2.0 * mach;
        let star = tube(ISOTHERMAL, [3.0, u], [3.0, -u]).star().unwrap();
        let root = 0.5 * (mach + f64::sqrt(mach * mach + 4.0));
        assert_near(
            star.left_density,
            3.0 * root * root,
            1e-13 * star.left_density,
            "meeting",
        );
        assert_near(star.velocity, 0.0, 1e-14 * u, "velocity");
        let star = tube(ISOTHERMAL, [3.0, -u], [3.0, u]).star().unwrap();
        assert_near(star.right_density, 3.0 * f64::exp(-mach), 3e-13, "parting");
    }
}

/// Parting streams of a liquid: `c = c_0 - (n-1)/2 u`, down to a vacuum, where the pressure is -B.
#[test]
fn a_liquid_that_parts_has_the_sound_speed_of_its_invariant() {
    let sound = |density: f64| LIQUID.sound_speed_squared(density, 0.0).sqrt();
    for u in [1e-3, 0.5, 1.2] {
        let star = tube(LIQUID, [1.5, -u], [1.5, u]).star().unwrap();
        assert_near(
            sound(star.left_density),
            4.0 - 3.0 * u,
            1e-12,
            "sound speed",
        );
        assert_near(
            star.pressure,
            LIQUID.pressure(star.left_density, 0.0),
            1e-12,
            "pressure",
        );
    }
    let vacuum = tube(LIQUID, [1.5, -1.4], [1.5, 1.4]);
    assert_eq!(vacuum.star(), None);
    assert_eq!(vacuum.sample(0.0).density, 0.0);
    assert_near(vacuum.left_wave()[1], -1.4 + 4.0 / 3.0, 1e-12, "edge");
}

/// Mass, momentum and, of what is kept account of, the total energy across every wave that is a
/// shock; the invariant and `de = p d rho/rho²` along every one that is a fan.
#[test]
fn waves_keep_mass_momentum_and_the_energy_that_is_kept_account_of() {
    for law in [ISOTHERMAL, LIQUID, LINEAR] {
        for (left, right) in [
            ([3.0, 0.0], [1.0, 0.0]),
            ([1.0, 0.5], [1.6, -0.5]),
            ([1.2, 3.0], [1.5, 0.0]),
            ([1.5, -0.2], [1.5 + 1e-9, 0.1]),
        ] {
            let solution = tube(law, left, right);
            let [first, last] = solution.left_wave();
            let (a, b) = (
                solution.sample(first - 1.0),
                solution.sample(last.max(first) + 1e-9),
            );
            let energy =
                |xi: f64, s: GasState| solution.internal_energy(xi) + 0.5 * s.velocity * s.velocity;
            if first == last {
                let flux = |s: GasState| s.density * (s.velocity - first);
                assert_near(flux(a), flux(b), 1e-12 * flux(a).abs(), "mass");
                let momentum = |s: GasState| flux(s) * s.velocity + s.pressure;
                let size = flux(a).abs() + a.pressure.abs() + b.pressure.abs();
                assert_near(momentum(a), momentum(b), 1e-11 * size, "momentum");
                let total = |xi, s: GasState| flux(s) * energy(xi, s) + s.pressure * s.velocity;
                let [before, behind] = [total(first - 1.0, a), total(first + 1e-9, b)];
                assert_near(before, behind, 1e-11 * (size + before.abs()), "energy");
                continue;
            }
            // Between points of a fan: u + the integral of c/rho, and the work of the pressure.
            let steps = 20_000;
            let at = |k: i32| first + (last - first) * f64::from(k) / f64::from(steps);
            let sound = |s: &GasState| law.sound_speed_squared(s.density, 0.0).sqrt();
            let (mut invariant, mut work) = (0.0, 0.0);
            for k in 0..steps {
                let [s, t] = [k, k + 1].map(|k| solution.sample(at(k)));
                let rise = t.density - s.density;
                invariant += 0.5 * (sound(&s) / s.density + sound(&t) / t.density) * rise;
                let pull = |s: &GasState| s.pressure / (s.density * s.density);
                work += 0.5 * (pull(&s) + pull(&t)) * rise;
                assert_near(t.pressure, law.pressure(t.density, 0.0), 1e-10, "law");
            }
            assert_near(
                solution.sample(last).velocity - a.velocity,
                -invariant,
                1e-6,
                "invariant",
            );
            assert_near(
                solution.internal_energy(last),
                work,
                1e-6 * (1.0 + work.abs()),
                "work",
            );
        }
    }
}

/// A stiffened gas and a liquid differ by what a shock heats, of third order in its strength.
#[test]
fn matter_of_different_laws_meets_at_one_pressure_and_velocity() {
    let water = (state(&LIQUID, 1.52, 1.0), LIQUID);
    let air = GasState {
        density: 0.1,
        velocity: 0.0,
        pressure: 0.2,
    };
    for (left, right) in [
        (water, (air, AIR)),
        ((air, AIR), water),
        (water, (state(&ISOTHERMAL, 0.2, 0.0), ISOTHERMAL)),
    ] {
        let solution = between(left, right).unwrap();
        let star = solution.star().unwrap();
        let [a, b] = [-1e-9, 1e-9].map(|off| solution.sample(star.velocity + off));
        assert_near(a.pressure, b.pressure, 1e-12, "pressure");
        assert_near(a.velocity, b.velocity, 1e-12, "velocity");
        for (state, law, density) in [
            (a, left.1, star.left_density),
            (b, right.1, star.right_density),
        ] {
            assert_eq!(state.density, density);
            if law.is_barotropic() {
                assert_near(law.pressure(density, 0.0), star.pressure, 1e-11, "law");
            }
        }
    }
    let n = 7.0;
    let stiffness = 1.5 * 16.0 / n;
    let gas = EquationOfState::StiffenedGas {
        gamma: n,
        pressure_at_infinity: stiffness,
    };
    let pressures = [(LIQUID, LIQUID), (gas, gas)].map(|(a, b)| {
        let [left, right] = [1.5 * 1.01, 1.5].map(|density| state(&LIQUID, density, 0.0));
        between((left, a), (right, b))
            .unwrap()
            .star()
            .unwrap()
            .pressure
    });
    assert_near(pressures[0], pressures[1], 1e-4 * pressures[0], "weak");
}

#[test]
fn isothermal_gases_that_part_for_ever_are_refused_and_name_the_cure() {
    let side = |u: f64| (state(&ISOTHERMAL, 1.0, u), ISOTHERMAL);
    let error = between(side(-1e4), side(1e4)).unwrap_err().to_string();
    assert!(error.contains("no vacuum"), "{error}");
    let bad = (
        GasState {
            density: -1.0,
            ..side(0.0).0
        },
        ISOTHERMAL,
    );
    let error = between(bad, side(0.0)).unwrap_err().to_string();
    assert!(error.contains("left density = -1"), "{error}");
}
