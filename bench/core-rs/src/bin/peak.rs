//! The most double-precision operations that a core does in a second: long runs of independent
//! multiplications and additions, held in registers; four lanes (AVX2), without and with fusing.
//!
//! Without fusing is the bound for rimroll, whose results are to be the same bits everywhere.

#[path = "../../../peers-rs/src/protocol.rs"]
#[expect(dead_code, reason = "only its clock is used here")]
mod protocol;

/// Chains that do not wait for each other: more than latency (4) times units (2).
const CHAINS: usize = 12;
const LANES: usize = 4;
const ROUNDS: usize = 20_000_000;

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn chains(fused: bool) -> f64 {
    use core::arch::x86_64::*;
    // Not known to the compiler, and such that no chain overflows or dies away.
    let factor = _mm256_set1_pd(core::hint::black_box(1.0 - 1e-9));
    let term = _mm256_set1_pd(core::hint::black_box(1e-9));
    let mut x = [_mm256_set1_pd(core::hint::black_box(1.0)); CHAINS];
    if fused {
        for _ in 0..ROUNDS {
            for chain in &mut x {
                *chain = _mm256_fmadd_pd(*chain, factor, term);
            }
        }
    } else {
        for _ in 0..ROUNDS {
            for chain in &mut x {
                *chain = _mm256_add_pd(_mm256_mul_pd(*chain, factor), term);
            }
        }
    }
    let mut sum = x[0];
    for chain in &x[1..] {
        sum = _mm256_add_pd(sum, *chain);
    }
    let mut lanes = [0.0; LANES];
    // SAFETY: there is room for four numbers.
    unsafe { _mm256_storeu_pd(lanes.as_mut_ptr(), sum) };
    lanes.iter().sum()
}

#[cfg(target_arch = "x86_64")]
fn main() {
    if !(is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")) {
        return println!("error this processor has no AVX2");
    }
    let rate = |fused| {
        let of_a_run = || {
            let begun = protocol::processor_seconds();
            // SAFETY: the processor has what the function asks for.
            core::hint::black_box(unsafe { chains(fused) });
            let taken = protocol::processor_seconds() - begun;
            (2 * CHAINS * LANES * ROUNDS) as f64 / taken
        };
        (0..5).map(|_| of_a_run()).fold(0.0, f64::max)
    };
    println!("{:e} {:e}", rate(false), rate(true));
}

#[cfg(not(target_arch = "x86_64"))]
fn main() {
    println!("error measured on x86-64 only");
}
