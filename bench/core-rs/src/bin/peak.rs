//! The most double-precision operations that a core does in a second: long runs of independent
//! multiplications and additions, held in registers; in the widest vectors that the processor has and
//! rimroll uses, of eight lanes (AVX-512) or of four (AVX2), without and with fusing.
//!
//! Without fusing is the bound for rimroll, whose results are to be the same bits everywhere.

#[path = "../../../peers-rs/src/protocol.rs"]
#[expect(dead_code, reason = "only its clock is used here")]
mod protocol;

/// Chains that do not wait for each other: more than latency (4) times units (2).
const CHAINS: usize = 12;
const ROUNDS: usize = 20_000_000;

/// A function that runs the chains, fused or not, in vectors of some lanes.
#[cfg(target_arch = "x86_64")]
macro_rules! in_vectors {
    ($name:ident, $features:literal, $lanes:literal,
     $set:ident, $add:ident, $multiply:ident, $fused:ident, $store:ident) => {
        #[target_feature(enable = $features)]
        fn $name(fused: bool) -> f64 {
            use core::arch::x86_64::{$add, $fused, $multiply, $set, $store};
            // Not known to the compiler, and such that no chain overflows or dies away.
            let factor = $set(core::hint::black_box(1.0 - 1e-9));
            let term = $set(core::hint::black_box(1e-9));
            let mut x = [$set(core::hint::black_box(1.0)); CHAINS];
            if fused {
                for _ in 0..ROUNDS {
                    for chain in &mut x {
                        *chain = $fused(*chain, factor, term);
                    }
                }
            } else {
                for _ in 0..ROUNDS {
                    for chain in &mut x {
                        *chain = $add($multiply(*chain, factor), term);
                    }
                }
            }
            let mut sum = x[0];
            for chain in &x[1..] {
                sum = $add(sum, *chain);
            }
            let mut lanes = [0.0; $lanes];
            // SAFETY: there is room for all lanes.
            unsafe { $store(lanes.as_mut_ptr(), sum) };
            lanes.iter().sum()
        }
    };
}

#[cfg(target_arch = "x86_64")]
in_vectors!(
    of_four,
    "avx2,fma",
    4,
    _mm256_set1_pd,
    _mm256_add_pd,
    _mm256_mul_pd,
    _mm256_fmadd_pd,
    _mm256_storeu_pd
);

#[cfg(target_arch = "x86_64")]
in_vectors!(
    of_eight,
    "avx512f",
    8,
    _mm512_set1_pd,
    _mm512_add_pd,
    _mm512_mul_pd,
    _mm512_fmadd_pd,
    _mm512_storeu_pd
);

#[cfg(target_arch = "x86_64")]
fn main() {
    let has_eight = is_x86_feature_detected!("avx512f");
    if !has_eight && !(is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")) {
        return println!("error this processor has no AVX2");
    }
    let lanes = if has_eight { 8 } else { 4 };
    // SAFETY: the processor has what the functions ask for.
    let run = |fused| unsafe {
        if has_eight {
            of_eight(fused)
        } else {
            of_four(fused)
        }
    };
    let rate = |fused| {
        let of_a_run = || {
            let begun = protocol::processor_seconds();
            core::hint::black_box(run(fused));
            let taken = protocol::processor_seconds() - begun;
            (2 * CHAINS * lanes * ROUNDS) as f64 / taken
        };
        (0..5).map(|_| of_a_run()).fold(0.0, f64::max)
    };
    println!("{lanes} {:e} {:e}", rate(false), rate(true));
}

#[cfg(not(target_arch = "x86_64"))]
fn main() {
    println!("error measured on x86-64 only");
}
