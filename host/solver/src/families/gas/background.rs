//! Materials without a background pressure.
//!
//! A pressure `p_0` that pushes equally from all sides moves nothing, but sums over particles out of order
//! do not see it as equal: their error is a part of `p_0`, and at a small Mach number larger than the differences
//! that drive the flow. Forces that leave it out are those of a material with `p' = p - p_0` and
//! `e' = e + p_0/ρ`: `de' = p' dρ/ρ²` along its isentropes, its speed of sound is the same, and its energy is kept as
//! exactly as that of any material. Each of the equations of state has it in its family:
//!
//! - ideal and stiffened gas: a stiffened gas with `p∞ + p_0`;
//! - isothermal gas: `p' = c² ρ - p_0`, Tait's law with n = 1 and `ρ0 = p_0/c²`;
//! - Tait's law: `B + p_0` in place of B, and `ρ0 (1 + p_0/B)^(1/n)` in place of ρ0.

use super::plan::Plan;
use crate::scenario::EquationOfState;

/// A material without the pressure `background`, >= 0; with 0 the material itself.
pub(super) fn without(law: &EquationOfState, background: f64) -> EquationOfState {
    if background == 0.0 {
        return *law;
    }
    match *law {
        EquationOfState::IdealGas { gamma } => EquationOfState::StiffenedGas {
            gamma,
            pressure_at_infinity: background,
        },
        EquationOfState::StiffenedGas {
            gamma,
            pressure_at_infinity,
        } => EquationOfState::StiffenedGas {
            gamma,
            pressure_at_infinity: pressure_at_infinity + background,
        },
        EquationOfState::Isothermal { sound_speed } => EquationOfState::Tait {
            density: background / (sound_speed * sound_speed),
            sound_speed,
            exponent: 1,
        },
        EquationOfState::Tait {
            density,
            sound_speed,
            exponent,
        } => {
            let n = f64::from(exponent);
            let stiffness = density * sound_speed * sound_speed / n;
            let stiffer = stiffness + background;
            let denser = density * libm::pow(stiffer / stiffness, 1.0 / n);
            EquationOfState::Tait {
                density: denser,
                sound_speed: (n * stiffer / denser).sqrt(),
                exponent,
            }
        }
    }
}

impl Plan {
    /// The pressure that the materials leave out, in the scenario's units.
    pub(super) fn background(&self) -> f64 {
        self.options.background * (self.units.density() * self.units.energy())
    }

    /// The volume of the domain, in the scenario's units.
    pub(super) fn volume(&self) -> f64 {
        let axes = self.axes[..self.dimension].iter();
        let lengths = axes.map(|axis| axis.upper - axis.lower);
        lengths.map(|length| length * self.units.length).product()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn laws() -> [EquationOfState; 4] {
        [
            EquationOfState::IdealGas { gamma: 1.4 },
            EquationOfState::StiffenedGas {
                gamma: 4.4,
                pressure_at_infinity: 6.0,
            },
            EquationOfState::Isothermal { sound_speed: 1.7 },
            EquationOfState::Tait {
                density: 0.9,
                sound_speed: 3.0,
                exponent: 7,
            },
        ]
    }

    #[test]
    fn pressures_are_less_by_the_background_and_sound_is_as_fast() {
        let background = 2.3;
        for law in laws() {
            let other = without(&law, background);
            for (density, energy) in [(1.0, 9.0), (0.95, 12.0), (1.2, 8.0)] {
                let pressure = law.pressure(density, energy);
                let found = other.pressure(density, energy + background / density);
                assert!(
                    (found - (pressure - background)).abs() < 1e-13 * (pressure.abs() + 10.0),
                    "{law:?}: {found} for {pressure} - {background}"
                );
                let [right, found] = [
                    law.sound_speed_squared(density, energy),
                    other.sound_speed_squared(density, energy + background / density),
                ];
                assert!(
                    (found / right - 1.0).abs() < 1e-13,
                    "{law:?}: {found}, {right}"
                );
            }
        }
    }

    #[test]
    fn without_a_background_a_material_is_itself() {
        for law in laws() {
            assert_eq!(without(&law, 0.0), law);
        }
    }
}
