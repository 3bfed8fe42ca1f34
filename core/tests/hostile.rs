//! The core under calls that no solver makes: in a build that checks overflow an error, a bound or a
//! value that means something, never a panic.

use fixed::types::extra::U16;
use motes_core::domain::{Axis, Domain};
use motes_core::equation::linear::systems::{Acoustics, Units};
use motes_core::equation::linear::{LinearDynamics, LinearStorage, Particle, Still};
use motes_core::error::{Container, Error, Parameter, Quantity};
use motes_core::integrator::{Clock, RK4, Stepper};
use motes_core::material::{EquationOfState, Tait};
use motes_core::neighbours::{CellBuffers, Cells, Grid, Image, Site, cell_bound, sort};
use motes_core::pairs::{Blocks, HalfLoop, Nothing};
use motes_core::scalar::{Lanes, Number, Q32, Scalar};

type Q = Q32<U16>;

#[test]
fn a_bound_of_cells_leaves_room_for_one_more() {
    for particles in [1 << 30, (1 << 30) + 1, 1 << 31, u32::MAX] {
        let bound = cell_bound(particles);
        assert!(bound.checked_add(1).is_some(), "{particles}: {bound}");
        assert!(bound >= cell_bound(particles - 1));
    }
    assert_eq!(cell_bound(100), 528);
}

#[test]
fn a_position_that_is_no_number_is_named() {
    for lost in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..3 {
            let mut positions = [[0.0, 1.0], [1.0, 2.0], [2.0, 0.0]];
            positions[place][place % 2] = lost;
            let error = Grid::fit(&Domain::FREE, &positions, 1.0);
            let (particle, quantity) = (place as u32, Quantity::Position);
            assert_eq!(error, Err(Error::NotFinite { particle, quantity }));
        }
    }
}

#[test]
fn a_step_that_is_no_number_moves_nothing() {
    let axes = [Axis::FREE, Axis::periodic(0.0, 1.0), Axis::walls(0.0, 1.0)];
    for axis in axes {
        for lost in [f32::NAN, f32::INFINITY] {
            let mut position = [0.5];
            let moved = Domain { axes: [axis] }.drift(&mut position, &[lost], 7);
            let (particle, quantity) = (7, Quantity::Position);
            assert_eq!(moved, Err(Error::NotFinite { particle, quantity }));
            assert_eq!(position, [0.5]);
        }
    }
}

#[test]
fn a_product_of_no_components_is_nothing() {
    assert_eq!(f64::dot::<0>(&[], &[]), 0.0);
    assert_eq!(Q::dot::<0>(&[], &[]), Q::ZERO);
    assert_eq!(Lanes::<f32, 4>::dot::<0>(&[], &[]), Lanes([0.0; 4]));
    assert_eq!(Lanes::<f32, 4>::length_squared::<0>(&[]), Lanes([0.0; 4]));
}

#[test]
fn an_image_of_many_directions_is_packed_and_unpacked() {
    let image = Image([1, 0, 2, 3, 4, 0, 1, 2, 3, 4]);
    assert_eq!(Image::<10>::unpacked(image.packed()), image);
    assert_eq!(Image::<3>::unpacked(u32::MAX), Image([7; 3]));
}

/// Sorts a cloud of one direction and looks at it.
fn with_cells(axis: Axis<f64>, look: impl Fn(&Cells<'_, f64, 1>)) {
    let positions: Vec<[f64; 1]> = (0..40).map(|i| [0.5 + f64::from(i)]).collect();
    let n = positions.len();
    let mut buffers = CellBuffers {
        sites: &mut vec![Site::EMPTY; n],
        order: &mut vec![0; n],
        cell_of: &mut vec![0; n],
        starts: &mut vec![0; cell_bound(n as u32) as usize + 1],
    };
    let domain = Domain { axes: [axis] };
    let grid = sort(&domain, &positions, &|_| 2.0, &mut buffers).unwrap();
    look(&buffers.cells(grid, n));
}

#[test]
fn cells_beyond_the_last_one_have_no_partners_of_their_own() {
    let axes = [
        Axis::FREE,
        Axis::periodic(0.0, 40.0),
        Axis::walls(0.0, 40.0),
    ];
    for axis in axes {
        with_cells(axis, |cells| {
            for cell in [u32::MAX, u32::MAX - 1, 1 << 31, 1000] {
                assert!(cells.row_end(&[cell]) <= 40);
                for last in [cell, u32::MAX] {
                    for run in &cells.runs(&[cell], last) {
                        assert!(run.start < run.end && run.end <= 40);
                    }
                }
                for mirror in 0..=u8::MAX {
                    for run in &cells.mirror_runs(&[cell], &[mirror]) {
                        assert!(run.start < run.end && run.end <= 40);
                    }
                }
            }
        });
    }
}

#[test]
fn blocks_end_with_the_receivers() {
    with_cells(Axis::FREE, |cells| {
        let starts = [0, 39, 40, u32::MAX as usize, usize::MAX - 1, usize::MAX];
        for start in starts {
            for end in [40, u32::MAX as usize, usize::MAX] {
                let blocks = Blocks::<f64, 1, 8>::new(cells, start, end);
                let covered: usize = blocks.map(|block| block.end - block.start).sum();
                assert_eq!(covered, 40usize.saturating_sub(start));
            }
        }
    });
}

#[test]
fn a_clock_counts_no_farther_than_it_can() {
    let mut clock = Clock::new(1.0f64);
    clock.steps = u64::MAX;
    assert_eq!(clock.tick(0.5), Ok(()));
    assert_eq!((clock.time, clock.steps), (0.5, u64::MAX));
}

#[test]
fn the_work_of_a_power_is_bounded() {
    // As many products would take longer than any test: 2^32 of them a pressure.
    let liquid = Tait::<f64>::new(1.0, 1.0, u32::MAX);
    assert_eq!(liquid.pressure(1.0, 0.0), 0.0);
    assert_eq!(liquid.sound_speed(1.0, 0.0), 1.0);
    assert_eq!(liquid.sound_speed(0.5, 0.0), 0.0);
    for n in [0, 1, 7, 16, 17, 31, 64, 1000] {
        let (power, exact) = (Scalar::powi(1.01f64, n), 1.01f64.powi(n as i32));
        assert!(
            (power - exact).abs() < 1e-12 * exact,
            "{n}: {power} {exact}"
        );
    }
}

#[test]
fn a_factor_of_the_step_out_of_its_range_is_refused() {
    const N: usize = 16;
    const CELLS: usize = cell_bound(N as u32) as usize + 1;
    for (courant, is_right) in [
        (1e300, false),
        (1.5, false),
        (0.0, false),
        (-0.5, false),
        (f64::NAN, false),
        (1.0, true),
        (0.01, true),
    ] {
        let mut storage = LinearStorage::<f64, Nothing, 1, 2, N, CELLS>::new();
        for k in 0..N {
            let particle = Particle {
                position: [k as f64 + 0.5],
                weight: 1.0,
                value: [1.0, 0.0],
            };
            storage.push(particle).unwrap();
        }
        let domain = Domain {
            axes: [Axis::periodic(0.0, N as f64)],
        };
        let sound = Acoustics::new(1.0, 1.0, Units::ONE);
        let cut_off = (motes_core::cutoff::QuinticSpline, 1.5);
        let dynamics = LinearDynamics::new(domain, cut_off, sound, Still, courant);
        let mut line = Stepper::new(dynamics, RK4, HalfLoop, storage).unwrap();
        let made = line.step();
        match is_right {
            true => assert!(made.is_ok()),
            false => {
                let parameter = Parameter::Courant;
                assert_eq!(made, Err(Error::Parameter { parameter }), "{courant}");
                assert_eq!(line.clock().steps, 0);
            }
        }
    }
}

#[test]
fn what_is_full_says_how_much_would_do() {
    let positions = [[0.0f64], [1.0], [2.0]];
    let mut buffers = CellBuffers {
        sites: &mut [Site::EMPTY; 2],
        order: &mut [0; 3],
        cell_of: &mut [0; 3],
        starts: &mut [0; 200],
    };
    let sorted = sort(&Domain::FREE, &positions, &|_| 1.0, &mut buffers);
    let full = Error::Capacity {
        container: Container::Particles,
        needed: 3,
        capacity: 2,
    };
    assert_eq!(sorted, Err(full));
}
