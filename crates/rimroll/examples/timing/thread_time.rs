//! What work costs on one thread, on a busy machine.

/// The time of this thread on a processor, s, which on a busy machine is less than the elapsed time. It is read from Linux.
fn seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").expect("Linux");
    let first = text.split(' ').next().and_then(|ns| ns.parse::<f64>().ok());
    first.expect("nanoseconds") * 1e-9
}

/// What comes of some work, and the least time of some `runs` of it, which is the least disturbed, in
/// microseconds for each of `count`.
pub fn timed<T>(count: usize, runs: usize, work: impl Fn() -> T) -> (T, f64) {
    let once = |_| {
        let begin = seconds();
        let result = work();
        (result, (seconds() - begin) / count as f64 * 1e6)
    };
    let results = (0..runs).map(once);
    results
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .expect("at least one run")
}
