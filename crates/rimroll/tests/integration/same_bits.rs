//! The same bits everywhere: the ends of motions and of a synthetic record, to the last bit.
//!
//! A change of these numbers changes every published result. It must be intended and recorded in the
//! changelog.

use rimroll::ground::Synthetic;
use rimroll::{Ground, IdealLaw, Options, State, presets, simulate};
use std::ops::ControlFlow;

fn bits_at_the_end(law: IdealLaw) -> Vec<u64> {
    let can = presets::can_2007().unwrap();
    let start = State {
        tilt: 0.5,
        tilt_rate: -0.5,
        yaw_rate: 0.005,
        spin_rate: 0.005,
        ..State::default()
    };
    let motion = simulate(&can, &start, law, &Options::default(), |_| {
        ControlFlow::Continue(())
    })
    .unwrap();
    motion.observables(&motion.trajectory.end())[1..8]
        .iter()
        .map(|number| number.to_bits())
        .collect()
}

#[test]
fn a_rolling_can_ends_at_the_same_bits() {
    assert_eq!(bits_at_the_end(IdealLaw::NoSlip), NO_SLIP);
}

#[test]
fn a_sliding_can_ends_at_the_same_bits() {
    assert_eq!(bits_at_the_end(IdealLaw::Frictionless), FRICTIONLESS);
}

#[test]
fn a_synthetic_record_ends_with_the_same_bits() {
    let ground = Ground::synthetic(&Synthetic {
        seed: 2007,
        peak: [3.0, 2.0, 1.0],
        step: 0.01,
        count: 2001,
        soil_period: 0.4,
        soil_damping: 0.6,
    });
    // Filters remember: the last sample depends on all others.
    let last = ground.unwrap().parts().1.unwrap().samples()[2000];
    assert_eq!(last.map(f64::to_bits), SYNTHETIC);
}

const SYNTHETIC: [u64; 3] = [
    13814766075927320773,
    4584157468991334285,
    13781712458629607612,
];

const NO_SLIP: [u64; 7] = [
    4597597934185858090,
    4614218794681936584,
    4624152900745587988,
    4580855927972095386,
    13847514294883969921,
    13799707039216170663,
    4576086345663898245,
];

const FRICTIONLESS: [u64; 7] = [
    4598501973039596129,
    13839589351431945040,
    4626125526178897907,
    4577986434586033453,
    13849491994210338335,
    13790225995898162124,
    4576565385061749008,
];
