use rimroll::{FrictionLaw, IdealLaw, Options, State, Surface, presets, simulate};
use std::ops::ControlFlow;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let n: usize = a[1].parse().unwrap();
    let surface = match a[2].as_str() {
        "n" => Surface::from(IdealLaw::NoSlip),
        "f" => Surface::from(IdealLaw::Frictionless),
        _ => Surface::from(FrictionLaw::Coulomb {
            friction: 0.2,
            static_friction: 0.2,
        }),
    };
    let can = presets::can_2007().unwrap();
    let start = State {
        tilt: core::f64::consts::FRAC_PI_6,
        tilt_rate: -0.5,
        yaw_rate: 0.005,
        spin_rate: 0.005,
        ..State::default()
    };
    let options = Options {
        gravity: 9.8,
        rtol: 1e-9,
        ..Options::default()
    };
    let mut sum = 0.0;
    for _ in 0..n {
        let m = simulate(&can, &start, surface, &options, |_| {
            ControlFlow::Continue(())
        })
        .unwrap();
        sum += m.track.end().yaw;
        if n == 1 {
            for p in m.track.phases() {
                println!("{:?} {}", p.phase, p.t);
            }
            println!("{:?}", m.work);
            let mut last = 0.0;
            let mut prev: Option<rimroll::motion::Instant> = None;
            let mut c = 0;
            for q in m.track.nodes() {
                let _ = last;
                last = q.t;
                if let Some(p) = prev {
                    if p.phase != q.phase {
                        println!("{:?} until {} steps {} tilt {:e}", p.phase, p.t, c, p.sin);
                        c = 0;
                    }
                }
                c += 1;
                prev = Some(q);
            }
            println!("last {}", c);
        }
    }
    println!("{sum}");
    if a.len() > 3 {
        let m = simulate(&can, &start, surface, &options, |_| {
            ControlFlow::Continue(())
        })
        .unwrap();
        let mut k = 0;
        let want: usize = a[3].parse().unwrap();
        let mut prev = m.track.start().phase;
        let mut tp = 0.0;
        for q in m.track.nodes() {
            if q.phase != prev {
                k += 1;
                prev = q.phase;
            }
            if k == want {
                println!(
                    "t {:.9} dt {:.2e} slip {:.3e} dir {:.3} sin {:.4} p {:.3} w {:.3e} s {:.3e}",
                    q.t,
                    q.t - tp,
                    q.slip_speed(),
                    q.slip_y.atan2(q.slip_x),
                    q.sin,
                    q.p,
                    q.w,
                    q.s
                );
            }
            tp = q.t;
        }
    }
}
#[allow(dead_code)]
fn nothing() {}
