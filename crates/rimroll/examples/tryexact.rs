use rimroll::{IdealLaw, State, presets, turn::exact::Exact};
fn main() {
    let text = std::fs::read_to_string("/work/shared/reference/turns.csv").unwrap();
    let can = presets::can_2007().unwrap();
    for (law, c) in [(IdealLaw::NoSlip, 4), (IdealLaw::Frictionless, 7)] {
        let exact = Exact::new(&can, law, 9.8, None).unwrap();
        let mut starts = vec![];
        let mut worst = [0.0f64; 3];
        for line in text.lines().filter(|l| !l.starts_with('#')).skip(1) {
            let v: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
            let s = State {
                tilt: v[0],
                tilt_rate: v[1],
                yaw_rate: v[2],
                spin_rate: v[3],
                ..State::default()
            };
            let t = exact.turn(&s).unwrap();
            starts.push(s);
            let e = [
                (t.turn - v[c]).abs(),
                (t.min_tilt / v[c + 1] - 1.0).abs(),
                (t.time / v[c + 2] - 1.0).abs(),
            ];
            if !(e[0] < 1e-12) {
                println!("{:?} {:?} {:?}", s, t, e);
            }
            for i in 0..3 {
                worst[i] = worst[i].max(e[i]);
            }
        }
        println!("{:?} {:?}", law, worst);
        let t0 = std::time::Instant::now();
        let mut sum = 0.0;
        let n = 200;
        for _ in 0..n {
            for s in &starts {
                sum += exact.turn(s).unwrap().turn;
            }
        }
        println!(
            "scalar {} us  {}",
            t0.elapsed().as_secs_f64() * 1e6 / (n * starts.len()) as f64,
            sum
        );
        let big: Vec<State> = starts.iter().cycle().take(60 * 200).cloned().collect();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(1)
            .build()
            .unwrap();
        let mut best = 1e9f64;
        let mut res = vec![];
        for _ in 0..20 {
            let t0 = std::time::Instant::now();
            res = pool.install(|| exact.turns(&big).unwrap());
            best = best.min(t0.elapsed().as_secs_f64());
        }
        println!("lanes {} us each", best * 1e6 / big.len() as f64);
        let mut worst = 0.0f64;
        let mut same = 0;
        for (i, s) in starts.iter().enumerate() {
            let a = exact.turn(s).unwrap();
            worst = worst.max((a.turn - res[i].turn).abs());
            if a == res[i] {
                same += 1
            }
        }
        println!("lanes vs alone {} {}", worst, same);
        let t0 = std::time::Instant::now();
        for _ in 0..100 {
            sum += Exact::new(&can, law, 9.8, None)
                .unwrap()
                .turn(&starts[0])
                .unwrap()
                .turn;
        }
        println!(
            "new {} us  {}",
            t0.elapsed().as_secs_f64() * 1e6 / 100.0,
            sum
        );
    }
}
