use rimroll::*;
fn main() {
    let can = presets::can_2007().unwrap();
    for law in LawKind::ALL {
        let s = State {
            tilt: core::f64::consts::PI / 6.0,
            tilt_rate: -0.5,
            yaw_rate: 5e-3,
            spin_rate: 5e-3,
            ..Default::default()
        };
        let p = pasted::pasted(&can, &s, law, 9.8).unwrap();
        println!(
            "{:?} t_c {} half {} b {:?}",
            p.near_collision,
            p.time,
            p.half_width,
            turn::error_law_coefficient(&can, law, p.near_collision.tipping_rate, 9.8)
        );
        let v = small_angle::lean_vector(&p.near_collision, 0.01);
        println!(
            "{} {:?} exact {}",
            v.len(),
            v.last(),
            p.near_collision.yaw(v.last().unwrap()[0])
        );
        println!(
            "{:?} {:?}",
            turn::lift_off_rate(&can, 9.8),
            turn::slip_rate(&can, 9.8)
        );
    }
    for b in [
        presets::soda_can(0.),
        presets::soda_can(1.),
        presets::beer_bottle(0.),
        presets::coin(),
        presets::euler_disk(),
        presets::battery(),
        presets::disk(0.1),
        presets::ring(0.1),
    ] {
        let b = b.unwrap();
        println!(
            "{b:?} {} {}",
            turn::turn_limit(&b, LawKind::NoSlip).to_degrees(),
            turn::turn_limit(&b, LawKind::Frictionless).to_degrees()
        );
    }
}
