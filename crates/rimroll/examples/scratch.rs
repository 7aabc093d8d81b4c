// compare lanes to stepped-alone: print worst difference between turn() and turns()
use rimroll::turn::exact::Exact;
use rimroll::{Body, IdealLaw, State, presets};
fn main() {
    let mut seed = 12345u64;
    let mut random = move || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let n: usize = 20000;
    let bodies = [("can", presets::can_2007().unwrap()), ("thick", Body::new(0.3, 0.1, 0.05, 0.003, 0.005).unwrap()), ("tall", Body::new(0.3, 0.02, 0.2, 0.016, 0.0001).unwrap()), ("disk", Body::new(0.1, 0.02, 0.0, 1e-5, 2e-5).unwrap())];
    for (name, body) in bodies {
        let nat = (9.8 / body.radius()).sqrt();
        for law in [IdealLaw::NoSlip, IdealLaw::Frictionless] {
            for (kind, w) in [("tame", 0.05), ("thrown", 0.1), ("wild", 0.6)] {
                let exact = Exact::new(&body, law, 9.8, None).unwrap();
                let mut between = |a: f64, b: f64| a + (b - a) * random();
                let starts: Vec<State> = (0..n).map(|_| State { tilt: between(0.05, 1.4), tilt_rate: between(-0.4, 0.4) * nat, yaw_rate: between(-w, w) * nat, spin_rate: between(-w, w) * nat, ..State::default() }).collect();
                let turns = exact.turns(&starts).unwrap();
                let mut worst = [0.0f64; 3];
                let (mut bad, mut differ, mut over) = (0, 0, 0);
                let mut example = None;
                for (s, t) in starts.iter().zip(&turns) {
                    let a = exact.turn(s).unwrap();
                    if a.ending != t.ending { differ += 1; if differ < 4 {println!("   {:?} {:?} {:?}", a.ending, t.ending, s);} continue; }
                    if t.turn.is_nan() { if !a.turn.is_nan() { bad += 1; } continue; }
                    let d = (t.turn - a.turn).abs();
                    if d > 1e-12 { over += 1; }
                    if d > worst[0] { worst[0] = d; example = Some(*s); }
                    worst[1] = worst[1].max((t.min_tilt / a.min_tilt - 1.0).abs());
                    worst[2] = worst[2].max((t.time / a.time - 1.0).abs());
                }
                println!("{name} {} {kind} differ {differ} bad {bad} over {over} worst {worst:?} {:?}", law.name(), example.map(|s| (s.tilt, s.tilt_rate, s.yaw_rate, s.spin_rate)));
            }
        }
    }
}
