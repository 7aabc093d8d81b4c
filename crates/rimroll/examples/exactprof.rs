use rimroll::{IdealLaw, State, presets, turn::exact::Exact};
fn main() {
    let law = if std::env::args().nth(1).unwrap() == "n" {
        IdealLaw::NoSlip
    } else {
        IdealLaw::Frictionless
    };
    let can = presets::can_2007().unwrap();
    let text = std::fs::read_to_string("/work/shared/reference/turns.csv").unwrap();
    let starts: Vec<State> = text
        .lines()
        .filter(|l| !l.starts_with('#'))
        .skip(1)
        .map(|line| {
            let v: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
            State {
                tilt: v[0],
                tilt_rate: v[1],
                yaw_rate: v[2],
                spin_rate: v[3],
                ..State::default()
            }
        })
        .collect();
    let big: Vec<State> = starts.iter().cycle().take(60 * 200).cloned().collect();
    let exact = Exact::new(&can, law, 9.8, None).unwrap();
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    let n: usize = std::env::args().nth(2).unwrap().parse().unwrap();
    let mut best = 1e9f64;
    for _ in 0..n {
        let t0 = std::time::Instant::now();
        pool.install(|| exact.turns(&big).unwrap());
        best = best.min(t0.elapsed().as_secs_f64());
    }
    println!("{} us", best * 1e6 / big.len() as f64);
}
