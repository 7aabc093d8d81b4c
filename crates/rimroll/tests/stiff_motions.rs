//! Motions in which something relaxes far faster than the body moves, so that explicit steps must be short.

use rimroll::law::Stribeck;
use rimroll::{Body, Options, State, Status, simulate};
use std::ops::ControlFlow;

/// A body with almost no moment of inertia, whose creep under regularised friction relaxes at rates beyond
/// 10⁸/s. Finite-difference Jacobians have errors of 7e-4 there, with which Newton's method converges only in
/// steps below 10⁻⁵ s.
///
/// The expected numbers are a solution of the sliding equations in Euler angles by SciPy's Radau at rtol 1e-9
/// with Jacobians by complex steps.
#[test]
fn creep_with_almost_no_inertia_takes_few_steps() {
    const END: [f64; 6] = [
        2.908_787_098_587_3e-3,
        -0.587_708_769_738_151,
        0.496_674_507_552_128,
        5.245_758_336_337_89,
        0.826_588_222_738_505,
        -5.264_833_386_312_34,
    ];
    let body = Body::new(
        0.002_944_242_252_346_658,
        0.478_818_083_361_459_26,
        3.466_671_753_830_571_6,
        6.589_179_824_933_931e-10,
        1.317_835_945_284_044_8e-9,
    )
    .expect("a rigid body");
    let start = State {
        tilt: 0.137_251_997_966_446_02,
        tilt_rate: -0.582_172_110_469_742_5,
        yaw: 0.471_307_550_140_513_95,
        yaw_rate: 0.002_145_849_745_075_836,
        spin: 0.856_383_022_553_334_4,
        spin_rate: -0.021_575_603_241_007_06,
    };
    let friction = Stribeck {
        friction: 0.573_999_440_366_278_1,
        static_friction: 0.573_999_440_366_278_1,
        stribeck_speed: 0.001_560_410_458_780_138_2,
        creep_speed: 0.000_441_676_303_807_391_74,
    };
    let options = Options {
        duration: 0.23,
        gravity: 1.310_274_272_201_064_3,
        rtol: 1e-8,
        max_steps: 1000,
        ..Options::default()
    };
    let go_on = |_| ControlFlow::Continue(());
    let motion = simulate(&body, &start, friction, &options, go_on).expect("valid input");
    assert_eq!(motion.status, Status::Finished);
    for (number, exact) in motion.track.end().state().numbers().iter().zip(END) {
        let error = (number - exact).abs() / exact.abs();
        assert!(error < 1e-7, "{number} is not {exact}");
    }
}
