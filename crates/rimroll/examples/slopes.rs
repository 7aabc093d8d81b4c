use rimroll::{Body, IdealLaw, State, motion::PARAMETERS, presets, turn::exact::Exact};
fn main() {
    let b = presets::can_2007().unwrap();
    let s = State {
        tilt: 0.5,
        tilt_rate: -0.5,
        yaw_rate: 0.05,
        spin_rate: 0.02,
        ..State::default()
    };
    for law in [IdealLaw::NoSlip, IdealLaw::Frictionless] {
        let e = Exact::new(&b, law, 9.8, None).unwrap();
        let sl = e.turn_slopes(&[s]).unwrap()[0];
        let f = |d: [f64; 12]| {
            let b2 = Body::new(
                b.mass() * (1. + d[6]),
                b.radius() * (1. + d[7]),
                b.height() * (1. + d[8]),
                b.transverse_inertia() * (1. + d[9]),
                b.axial_inertia() * (1. + d[10]),
            )
            .unwrap();
            let s2 = State {
                tilt: s.tilt * (1. + d[0]),
                tilt_rate: s.tilt_rate * (1. + d[1]),
                yaw_rate: s.yaw_rate * (1. + d[3]),
                spin_rate: s.spin_rate * (1. + d[5]),
                ..s
            };
            Exact::new(&b2, law, 9.8 * (1. + d[11]), None)
                .unwrap()
                .turn(&s2)
                .unwrap()
                .turn
        };
        let v = [
            s.tilt,
            s.tilt_rate,
            0.,
            s.yaw_rate,
            0.,
            s.spin_rate,
            b.mass(),
            b.radius(),
            b.height(),
            b.transverse_inertia(),
            b.axial_inertia(),
            9.8,
        ];
        for i in 0..12 {
            let h = 1e-5;
            let mut p = [0.; 12];
            p[i] = h;
            let mut m = [0.; 12];
            m[i] = -h;
            println!(
                "{} {:.9} {:.9}",
                PARAMETERS[i],
                sl[i] * v[i],
                (f(p) - f(m)) / (2. * h)
            );
        }
    }
}
