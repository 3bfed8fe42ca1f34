//! The scalars that runs can be made with, by name.

use motes_solver::compiled::Compiled;

macro_rules! scalars {
    ($($(#[$only:meta])? $variant:ident, $name:literal, $what:literal, $runs:expr, $checked:expr;)*) => {
        /// A scalar that runs can be made with.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum ScalarName {
            $($(#[$only])? #[doc = $what] $variant,)*
        }

        impl ScalarName {
            /// All of them, with what they are.
            pub const ALL: &'static [(Self, &'static str, &'static str)] =
                &[$($(#[$only])? (Self::$variant, $name, $what),)*];

            /// Its simulations; with `checked` those that mark overflow, where its arithmetic has
            /// such, and stop at the first.
            pub(crate) fn compiled(self, checked: bool) -> &'static Compiled {
                match (self, checked) {
                    $($(#[$only])? (Self::$variant, false) => &$runs,)*
                    $($(#[$only])? (Self::$variant, true) => &$checked,)*
                }
            }
        }
    };
}

scalars! {
    F64, "f64", "IEEE double precision", motes_f64::F64, motes_f64::F64;
    F32, "f32", "IEEE single precision", motes_f32::F32, motes_f32::F32;
    #[cfg(feature = "fixed-point")]
    Micromath, "micromath", "f32 with approximate square roots",
        motes_micromath::MICROMATH, motes_micromath::MICROMATH;
    #[cfg(feature = "every-scalar")]
    Q9p22, "q9.22", "32-bit fixed point, 22 fractional bits",
        motes_fixed32::Q9P22, motes_checked::Q9P22;
    #[cfg(feature = "every-scalar")]
    Q11p20, "q11.20", "32-bit fixed point, 20 fractional bits",
        motes_fixed32::Q11P20, motes_checked::Q11P20;
    #[cfg(feature = "fixed-point")]
    Q12p19, "q12.19", "32-bit fixed point, 19 fractional bits",
        motes_fixed32::Q12P19, motes_checked::Q12P19;
    #[cfg(feature = "every-scalar")]
    Q13p18, "q13.18", "32-bit fixed point, 18 fractional bits",
        motes_fixed32::Q13P18, motes_checked::Q13P18;
    #[cfg(feature = "fixed-point")]
    Q15p16, "q15.16", "32-bit fixed point, 16 fractional bits",
        motes_fixed32::Q15P16, motes_checked::Q15P16;
    #[cfg(feature = "every-scalar")]
    Q19p12, "q19.12", "32-bit fixed point, 12 fractional bits",
        motes_fixed32::Q19P12, motes_checked::Q19P12;
    #[cfg(feature = "every-scalar")]
    Q15p48, "q15.48", "64-bit fixed point, 48 fractional bits",
        motes_fixed64::Q15P48, motes_checked::Q15P48;
    #[cfg(feature = "every-scalar")]
    Q23p40, "q23.40", "64-bit fixed point, 40 fractional bits",
        motes_fixed64::Q23P40, motes_checked::Q23P40;
    #[cfg(feature = "fixed-point")]
    Q31p32, "q31.32", "64-bit fixed point, 32 fractional bits",
        motes_fixed64::Q31P32, motes_checked::Q31P32;
}

/// A name that no scalar has.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error("unknown scalar `{}`", crate::scenario::shortened(name))]
#[diagnostic(help("this build has {}{}", ScalarName::list(), ScalarName::more()))]
pub struct UnknownScalar {
    /// The name.
    pub name: String,
}

impl ScalarName {
    /// The names, separated by commas.
    pub fn list() -> String {
        let names: Vec<_> = Self::ALL.iter().map(|(_, name, _)| *name).collect();
        names.join(", ")
    }

    /// How to have the formats that this build lacks; empty where it lacks none.
    pub(crate) fn more() -> &'static str {
        if cfg!(feature = "every-scalar") {
            ""
        } else if cfg!(feature = "fixed-point") {
            "; q9.22, q11.20, q13.18, q19.12, q15.48 and q23.40 come with `cargo run --release \
             --features every-scalar`"
        } else {
            "; fixed point and micromath come without `--no-default-features`"
        }
    }

    /// Whether it is fixed point.
    pub fn is_fixed(self) -> bool {
        self.name().starts_with('q')
    }

    /// Bits behind the point of its numbers at 1: neighbours there are `2^-bits` apart. In fixed point
    /// they are so everywhere.
    pub fn fraction_bits(self) -> u32 {
        let behind = self.name().split_once('.');
        match behind.and_then(|(_, bits)| bits.parse().ok()) {
            Some(bits) => bits,
            None if self == Self::F64 => f64::MANTISSA_DIGITS - 1,
            None => f32::MANTISSA_DIGITS - 1,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        let row = Self::ALL.iter().find(|(scalar, ..)| *scalar == self);
        row.map_or("", |(_, name, _)| name)
    }
}

impl std::str::FromStr for ScalarName {
    type Err = UnknownScalar;

    fn from_str(name: &str) -> Result<Self, UnknownScalar> {
        let row = Self::ALL.iter().find(|(_, known, _)| *known == name);
        row.map(|(scalar, ..)| *scalar)
            .ok_or_else(|| UnknownScalar {
                name: name.to_owned(),
            })
    }
}
