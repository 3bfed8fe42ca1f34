//! Sums of strengths, and the loops among each other.

use fixed::types::extra::{U16, U19, U32};
use motes_core::equation::diffusion::{Condition, Form, Heat};
use motes_core::integrator::{RK4, SSP_RK3};
use motes_core::pairs::{HalfLoop, PlainLoop};
use motes_core::scalar::{Q32, Q64, Scalar};

use crate::clouds::{Slab, fill, line, run, storage};

/// In fixed point the sum of the strengths is the same number at the end to the last bit, between
/// walls that let nothing through; the half loop gives the bits of the plain one.
#[test]
fn sums_are_conserved_to_the_bit_in_fixed_point_and_to_rounding_in_floats() {
    fn drift<S: Scalar>(form: Form) -> (bool, f64) {
        let n = 48;
        let mut storage = storage::<S, 1, 64>();
        fill(&mut storage, n, |x| (-x * x / 30.0).exp());
        let solver = line::<S, _>(
            n,
            Heat {
                diffusivity: S::ONE,
            },
            form,
            1.5,
        );
        let (mut state, mut work) = storage.parts();
        state.weigh();
        let first = state.total()[0];
        let sides = run(&solver, &SSP_RK3, &mut state, &mut work, S::count(60));
        assert!(sides > 30, "{sides}");
        let last = state.total()[0];
        let moved = S::rounded(last).to_f64() - S::rounded(first).to_f64();
        let middle = state.value[n as usize / 2][0].to_f64();
        assert!(middle < 0.6, "nothing happened: {middle}");
        (S::wide_bits(first) == S::wide_bits(last), moved.abs())
    }
    for form in [Form::Direct, Form::Mixed] {
        assert!(drift::<Q32<U19>>(form).0, "q12.19 {form:?}");
        assert!(drift::<Q32<U16>>(form).0, "q15.16 {form:?}");
        assert!(drift::<Q64<U32>>(form).0, "q31.32 {form:?}");
        assert!(drift::<f64>(form).1 < 1e-13);
        assert!(drift::<f32>(form).1 < 1e-4);
    }
}

#[test]
fn the_half_loop_gives_the_bits_of_the_plain_loop() {
    fn bits<S: Scalar>(form: Form, plain: bool) -> Vec<u128> {
        let n = 48;
        let mut storage = storage::<S, 1, 64>();
        fill(&mut storage, n, |x| (-x * x / 30.0).exp());
        let ends = [Condition::Value(S::ONE), Condition::Flux(S::ONE.half())];
        let solver = line::<S, _>(n, Slab { ends }, form, 1.5);
        let (mut state, mut work) = storage.parts();
        solver
            .prepare(&mut PlainLoop, &mut state, &mut work)
            .unwrap();
        for _ in 0..10 {
            let step = (S::ZERO, S::ONE.half());
            match plain {
                true => solver.advance(&RK4, &mut PlainLoop, &mut state, &mut work, step),
                false => solver.advance(&RK4, &mut HalfLoop, &mut state, &mut work, step),
            }
            .unwrap();
        }
        state.strength.iter().map(|q| S::wide_bits(q[0])).collect()
    }
    for form in [Form::Direct, Form::Mixed] {
        assert_eq!(bits::<f32>(form, true), bits::<f32>(form, false));
        assert_eq!(bits::<Q32<U19>>(form, true), bits::<Q32<U19>>(form, false));
    }
}
