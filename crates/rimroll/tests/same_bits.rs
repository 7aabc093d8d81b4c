//! The same bits everywhere: the end of a motion, to the last bit, as this crate has always computed it.
//!
//! A change of these numbers is a change of every published result: it must be meant, and said in the
//! changelog.

use rimroll::{IdealLaw, Options, State, presets, simulate};
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
    motion.moment(&motion.track.end())[1..8]
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

const NO_SLIP: [u64; 7] = [
    4597597934185990614,
    4614218794681864401,
    4624152900745588051,
    4580855927971943278,
    13847514294883969974,
    13799707039215858033,
    4576086345663906033,
];

const FRICTIONLESS: [u64; 7] = [
    4598501973039494699,
    13839589351432011432,
    4626125526178898003,
    4577986434586268047,
    13849491994210338341,
    13790225995899106948,
    4576565385061749008,
];
