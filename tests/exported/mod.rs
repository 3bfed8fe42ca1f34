//! What is exported, run to the end as on a device.

#[rustfmt::skip]
mod block;
#[rustfmt::skip]
mod cloud;
#[rustfmt::skip]
mod medium;
#[rustfmt::skip]
mod reactor;
#[rustfmt::skip]
mod shear;
#[rustfmt::skip]
mod sound;
#[rustfmt::skip]
mod stream;

use motes_core::digest::Digest;
use motes_core::error::Error;

/// The digest of an exported run at its end.
type Outcome = Result<Digest, Error>;

/// Runs a module in a scalar to its end.
macro_rules! digest {
    ($module:ident, $scalar:ty) => {{
        let run = || -> Outcome {
            // On a device it is a `static`.
            let mut memory = Box::new($module::Memory::<$scalar>::new());
            let mut run = $module::start(&mut memory)?;
            while run.step()?.is_some() {}
            Ok(run.state().digest())
        };
        ($module::NAME, stringify!($scalar), run())
    }};
}

/// Every module in both floats: its scenario, its scalar, and what it comes to.
pub fn digests() -> Vec<(&'static str, &'static str, Outcome)> {
    vec![
        digest!(block, f64),
        digest!(block, f32),
        digest!(cloud, f64),
        digest!(cloud, f32),
        digest!(medium, f64),
        digest!(medium, f32),
        digest!(reactor, f64),
        digest!(reactor, f32),
        digest!(shear, f64),
        digest!(shear, f32),
        digest!(sound, f64),
        digest!(sound, f32),
        digest!(stream, f64),
        digest!(stream, f32),
    ]
}
