//! Motions whose start no public function takes: the rim slips at the start.

use super::event_detector::Goal;
use super::run::Run;
use super::{COLUMNS, Contacts, Options, Phase, Status, observables};
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::ground::{Ground, Pulse, Shape};
use crate::law::FrictionLaw;
use crate::state::{Coordinates, State};
use core::ops::ControlFlow;
use std::sync::Arc;

/// One period of a sine.
fn sine(amplitude: [f64; 3], period: f64) -> Pulse {
    Pulse {
        amplitude,
        shape: Shape::Sine { period },
        duration: period,
    }
}

/// A drum of 200 kg that slides with friction 0.1 throughout, from a slip of 1 m/s. The reference motion (s5 in the
/// table) has 13 digits; 1e-10 allows for the errors of the steps, which the near-collisions amplify.
#[test]
fn a_drum_slides_on_a_moving_table_as_in_the_reference_motion() {
    const GRAVITY: f64 = 9.81;
    let body = Body::new(200.0, 0.3, 0.45, 18.0, 9.0).unwrap();
    let pulses = vec![sine([3.0, 0.0, 0.0], 0.6), sine([0.0, -2.0, 0.0], 0.4)];
    let ground = Arc::new(Ground::pulses(pulses).unwrap());
    let options = Options {
        duration: 0.4,
        gravity: GRAVITY,
        rtol: 1e-13,
        ..Options::default()
    };
    let law: ContactLaw = FrictionLaw::coulomb(0.1).into();
    let tolerance = options.step_tolerance();
    let contacts = Contacts::on_table(&body, &law, Some(ground), GRAVITY, tolerance);
    let contacts = Arc::new(contacts);
    let state = State {
        tilt: 0.2,
        yaw: 0.5,
        yaw_rate: 0.3,
        spin_rate: 0.2,
        ..State::default()
    };
    let start = Coordinates {
        slip_x: 0.6,
        slip_y: 0.8,
        ..Coordinates::from_state(&state)
    };
    let mut run = Run::new(&contacts, &options, Goal::Time(options.duration), start);
    let status = run.follow_to_the_end(&mut |_| ControlFlow::Continue(()));
    assert_eq!(status, Status::Finished);
    let (trajectory, ..) = run.into_parts();
    assert!(trajectory.nodes().all(|node| node.phase == Phase::Sliding));

    let [sin, cos] = [libm::sin(state.yaw), libm::cos(state.yaw)];
    let away = contacts.parameters().rho(&start);
    let table = include_str!("../../tests/integration/given/shaken_motions.csv");
    let mut lines = table.lines().filter(|line| !line.starts_with('#'));
    let columns: Vec<&str> = lines.next().unwrap().split(',').collect();
    let mut compared = 0;
    for line in lines.filter(|line| line.starts_with("s5,")) {
        let entry = |i: usize| line.split(',').nth(i).unwrap().parse::<f64>().unwrap();
        let at = trajectory.at(entry(1));
        let found = observables(contacts.dynamics(at.phase), &at, None);
        let value = |name| found[COLUMNS.iter().position(|column| *column == name).unwrap()];
        for (i, &column) in columns.iter().enumerate().skip(2) {
            // Positions are counted from the first point of contact, those of the motion from the first centre.
            let found = match column {
                "x" => value("x") + away * cos,
                "y" => value("y") + away * sin,
                "normal_over_weight" => value("normal_force") / (body.mass() * GRAVITY),
                other => value(other),
            };
            let error = (found - entry(i)).abs() / (1.0 + entry(i).abs());
            assert!(error < 1e-10, "{column} at {} s: {error:e}", entry(1));
            compared += 1;
        }
    }
    assert_eq!(compared, 4 * 10);
}
