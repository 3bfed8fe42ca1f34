use super::*;

const PROBLEM: ChannelProblem = ChannelProblem {
    axis: 1,
    walls: [-1.0, 2.0],
    velocities: [[0.5, 0.0, -1.0], [2.0, 0.0, 1.0]],
    viscosity: 0.7,
    acceleration: [1.5, 0.0, 0.0],
    start: FlowState {
        density: 3.0,
        velocity: [1.0, 0.0, 0.25],
        pressure: 2.0,
        energy: 4.0,
    },
};

#[test]
fn it_obeys_the_equation_and_sticks_to_the_walls() {
    let flow = PROBLEM.solve().unwrap();
    let u = |y, t| flow.at([0.3, y, 0.0], t).velocity;
    let step = 1e-3;
    for time in [0.02, 0.1, 0.7] {
        for (wall, velocity) in PROBLEM.walls.into_iter().zip(PROBLEM.velocities) {
            for (found, exact) in u(wall, time).iter().zip(velocity) {
                assert!((found - exact).abs() < 1e-12, "{found} for {exact}");
            }
        }
        for y in [-0.6, 0.1, 1.4] {
            for i in [0, 2] {
                let rate = (u(y, time + 1e-5)[i] - u(y, time - 1e-5)[i]) / 2e-5;
                let bend = (u(y + step, time)[i] - 2.0 * u(y, time)[i] + u(y - step, time)[i])
                    / (step * step);
                let exact = PROBLEM.viscosity * bend + PROBLEM.acceleration[i];
                assert!(
                    (rate - exact).abs() < 1e-3 * (1.0 + exact.abs()),
                    "{rate} for {exact}"
                );
            }
        }
    }
}

#[test]
fn it_begins_as_told_and_ends_steady() {
    let flow = PROBLEM.solve().unwrap();
    for time in [0.0, 1e-4] {
        let state = flow.at([0.0, 0.5, 0.0], time);
        for (found, exact) in state.velocity.iter().zip(PROBLEM.start.velocity) {
            assert!(
                (found - exact).abs() < 2e-4,
                "{found} for {exact} at {time}"
            );
        }
    }
    let middle = flow.at([0.0, 0.5, 0.0], 100.0).velocity;
    let steady = 1.25 + 1.5 * 9.0 / (8.0 * 0.7);
    assert!(
        (middle[0] - steady).abs() < 1e-12,
        "{middle:?} for {steady}"
    );
}
