use rimroll::{Body, IdealLaw, State, turn::exact::Exact};
fn main() {
    let text = std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap();
    let mut lines = text.lines().filter(|l| !l.starts_with('#'));
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let col = |n: &str| {
        names
            .iter()
            .position(|x| *x == n)
            .unwrap_or_else(|| panic!("{n} in {names:?}"))
    };
    let mut worst = [0.0f64; 5];
    for line in lines {
        let v: Vec<&str> = line.split(',').collect();
        let f = |n: &str| v[col(n)].parse::<f64>().unwrap();
        for law in [IdealLaw::NoSlip, IdealLaw::Frictionless] {
            let g = |n: &str| {
                v[col(&format!("{n}_{}", law.name()))]
                    .parse::<f64>()
                    .unwrap_or(f64::NAN)
            };
            if v[col(&format!("turn_{}", law.name()))].is_empty() {
                continue;
            }
            let body = Body::new(
                f("mass"),
                f("radius"),
                f("height"),
                f("transverse_inertia"),
                f("axial_inertia"),
            )
            .unwrap();
            let s = State {
                tilt: f("tilt"),
                tilt_rate: f("tilt_rate"),
                yaw_rate: f("yaw_rate"),
                spin_rate: f("spin_rate"),
                ..State::default()
            };
            let exact = match Exact::new(&body, law, f("gravity"), None) {
                Ok(e) => e,
                Err(e) => {
                    println!("{e}");
                    continue;
                }
            };
            let t = match exact.turn(&s) {
                Ok(e) => e,
                Err(e) => {
                    println!("{e}");
                    continue;
                }
            };
            let e = [
                (t.turn - g("turn")).abs(),
                (t.min_tilt / g("min_tilt") - 1.0).abs(),
                (t.max_tilt / g("max_tilt") - 1.0).abs(),
                (t.min_time / g("min_time") - 1.0).abs(),
                (t.time / g("time") - 1.0).abs(),
            ];
            let bad = !(e[0] < 1e-12 * (1.0f64).max(1.0));
            if bad || e[4] > 1e-11 {
                println!(
                    "{} {:?} y {} {} err {:?} {:?}",
                    v[0],
                    law,
                    f("tilt"),
                    f("tilt_rate"),
                    e,
                    t.ending
                );
            }
            for i in 0..5 {
                if e[i].is_nan() {
                    worst[i] = f64::NAN
                } else {
                    worst[i] = worst[i].max(e[i]);
                }
            }
        }
    }
    println!("{:?}", worst);
}
