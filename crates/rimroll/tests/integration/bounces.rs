//! The events of motions in which the rim leaves the table and comes down again.

use core::f64::consts::PI;
use core::ops::ControlFlow;
use rimroll::law::Stribeck;
use rimroll::motion::{EventKind, Phase};
use rimroll::{Body, ContactLaw, FrictionLaw, Motion, Options, State, Status, presets, simulate};

fn body(mass: f64, radius: f64, height: f64, transverse: f64, axial: f64) -> Body {
    Body::new(mass, radius, height, transverse, axial).expect("a rigid body")
}

fn coulomb(friction: f64, restitution: f64) -> ContactLaw {
    ContactLaw {
        restitution,
        ..FrictionLaw::coulomb(friction).into()
    }
}

fn follow(body: &Body, start: &State, contact_law: ContactLaw, options: &Options) -> Motion {
    simulate(body, start, contact_law, options, |_| {
        ControlFlow::Continue(())
    })
    .expect("valid input")
}

fn noted(motion: &Motion, kind: EventKind) -> Vec<f64> {
    let of_kind = motion.events.iter().filter(|event| event.kind == kind);
    of_kind.map(|event| event.at.t).collect()
}

/// Thrown down by its upper edge, the can passes the upright position in the air and rises on the other side.
fn over_upright(yaw_rate: f64) -> Motion {
    let start = State {
        tilt: 0.2,
        tilt_rate: -12.0,
        yaw_rate,
        ..State::default()
    };
    let options = Options {
        duration: 1.0,
        gravity: 9.8,
        ..Options::default()
    };
    let can = presets::can_2007().expect("the paper's can");
    follow(&can, &start, coulomb(0.3, 0.0), &options)
}

#[test]
fn a_flight_through_upright_has_its_smallest_tilt_there() {
    let motion = over_upright(0.0);
    assert_eq!(motion.status, Status::Toppled);
    let lowest: Vec<_> = motion
        .events
        .iter()
        .filter(|event| event.kind == EventKind::TiltMin)
        .collect();
    assert_eq!(lowest.len(), 1);
    assert_eq!(lowest[0].at.phase, Phase::Flying);
    assert!(lowest[0].at.tilt() <= 1e-9);
    // In plane motion the body comes up on the other side.
    assert_eq!(motion.trajectory.end().yaw, PI);
}

#[test]
fn mirror_images_that_fly_past_upright_are_mirror_images() {
    let (left, right) = (over_upright(1e-12), over_upright(-1e-12));
    for motion in [&left, &right] {
        assert_eq!(motion.status, Status::Toppled);
    }
    let [a, b] = [left.trajectory.end(), right.trajectory.end()];
    assert_eq!((a.t, a.tilt(), a.yaw), (b.t, b.tilt(), -b.yaw));
}

/// Here the rim bounces near an extremum of the tilt. Some impacts reverse the sign of the tilt rate to a
/// value that is within rounding of zero at this tolerance.
#[test]
fn each_turn_begins_where_the_last_one_ended_also_in_bounces() {
    let ring = body(
        16.298148966963655,
        1.6679063954430855,
        0.11749424541204852,
        32.793364626760294,
        32.590902201899645,
    );
    let start = State {
        tilt: 0.8616630085105733,
        tilt_rate: -0.030625100742834314,
        yaw: 1.7029134544583018,
        yaw_rate: -350.892623513998,
        ..State::default()
    };
    let table = ContactLaw {
        restitution: 0.47093740623372704,
        ..FrictionLaw::Stribeck(Stribeck {
            friction: 0.13717910009398204,
            static_friction: 0.1371792258810158,
            stribeck_speed: 0.0050360221607629015,
            creep_speed: 7.888789016071018e-05,
        })
        .into()
    };
    let options = Options {
        duration: 6.987217167157395,
        gravity: 9.80665,
        rtol: 3.0494989326793703e-7,
        ..Options::default()
    };
    let motion = follow(&ring, &start, table, &options);
    assert!(motion.turns.len() > 100);
    for pair in motion.turns.windows(2) {
        assert_eq!(pair[0].end, pair[1].start);
    }
}

#[test]
fn a_body_that_topples_in_the_air_does_not_pass_its_edge() {
    let needle = body(
        0.120489881788839,
        0.00325205638620542,
        9.26363852318419e-05,
        1.4878987212891293e-06,
        1.2988230409667275e-12,
    );
    let start = State {
        tilt: 1.542318548231033,
        tilt_rate: -143.1501564258839,
        yaw_rate: -140.05444307982972,
        spin: 2.848067674814839,
        spin_rate: -0.0013608996039651592,
        ..State::default()
    };
    let options = Options {
        duration: 0.018653131547435847,
        gravity: 9.80665,
        rtol: 9.542782324659712e-07,
        ..Options::default()
    };
    let motion = follow(
        &needle,
        &start,
        coulomb(0.025492104385064596, 0.513832889161151),
        &options,
    );
    assert_eq!(motion.status, Status::Toppled);
    assert_eq!(motion.trajectory.end().phase, Phase::Flying);
    assert!(noted(&motion, EventKind::OnEdge).is_empty());
    for turn in &motion.turns {
        assert!(turn.end <= motion.trajectory.end().t);
    }
}

/// The normal force at a lift-off is zero up to rounding and can have either sign.
#[test]
fn a_rim_that_slides_needs_the_friction_of_the_table_until_it_leaves_it() {
    let ring = body(0.0184, 0.618, 0.0143, 0.0073, 0.0146);
    let start = State {
        tilt: 1.4327,
        tilt_rate: 3.908,
        yaw_rate: -1.6614,
        spin_rate: 5.1626,
        ..State::default()
    };
    let options = Options {
        duration: 1.0,
        ..Options::default()
    };
    let motion = follow(&ring, &start, coulomb(0.6947, 0.0), &options);
    let column = rimroll::motion::COLUMNS
        .iter()
        .position(|&name| name == "friction_ratio")
        .expect("a column");
    let sliding: Vec<_> = motion
        .trajectory
        .nodes()
        .filter(|at| at.phase == Phase::Sliding)
        .collect();
    assert!(!noted(&motion, EventKind::LiftOff).is_empty() && !sliding.is_empty());
    for at in sliding {
        assert!((motion.observables(&at)[column] - 0.6947).abs() < 1e-12);
    }
}
