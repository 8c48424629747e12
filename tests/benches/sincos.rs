//! Times the sines and cosines of all joints: the runtime's own, the standard library's and `libm`'s.
//!
//! In: `cargo bench -p homogen-tests --bench sincos`, with and without
//! `RUSTFLAGS=-Ctarget-cpu=native`. Out: nanoseconds per call, medians of alternating runs of the
//! three, and their ratios. `-- --exhaustive` prints the worst errors of single precision over all
//! finite angles instead, in minutes. It asserts nothing.

use core::array::from_fn;
use core::hint::black_box;
use homogen::trigonometry::{sin_cos_all_f32, sin_cos_all_f64, single};
use std::time::Instant;

/// Sines and cosines of `N` angles.
type Pair<T, const N: usize> = ([T; N], [T; N]);

/// Calls between two readings of the clock.
const CALLS: usize = 1_000;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if arguments.iter().any(|argument| argument == "--exhaustive") {
        exhaustive();
    } else if arguments.iter().any(|argument| argument == "--bench") {
        println!("type   N    own ns    std ns   libm ns   own/std  own/libm");
        double::<1>();
        double::<6>();
        double::<7>();
        double::<12>();
        double::<29>();
        single::<1>();
        single::<6>();
        single::<7>();
        single::<12>();
        single::<29>();
    }
}

fn double<const N: usize>() {
    let angles = angles();
    report("f64", N, || {
        [
            time(&angles, |angles: [f64; N]| sin_cos_all_f64(angles)),
            time(&angles, |angles| one_by_one(angles, f64::sin_cos)),
            time(&angles, |angles| one_by_one(angles, libm::sincos)),
        ]
    });
}

fn single<const N: usize>() {
    let angles = angles::<N>().map(|angles| angles.map(rounded));
    report("f32", N, || {
        [
            time(&angles, |angles: [f32; N]| sin_cos_all_f32(angles)),
            time(&angles, |angles| one_by_one(angles, f32::sin_cos)),
            time(&angles, |angles| one_by_one(angles, libm::sincosf)),
        ]
    });
}

/// Prints the medians of 31 repetitions.
fn report(name: &str, joints: usize, measure: impl Fn() -> [f64; 3]) {
    let samples: [[f64; 3]; 31] = from_fn(|_| measure());
    let [own, std, libm] = from_fn(|i| {
        let mut times = samples.map(|times| times[i]);
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    });
    println!(
        "{name} {joints:>3} {own:>9.1} {std:>9.1} {libm:>9.1} {:>9.2} {:>9.2}",
        own / std,
        own / libm,
    );
}

/// Nanoseconds per call.
#[expect(clippy::cast_precision_loss, reason = "CALLS is small")]
fn time<T: Copy, const N: usize>(
    angles: &[[T; N]; CALLS],
    sin_cos_all: impl Fn([T; N]) -> Pair<T, N>,
) -> f64 {
    let start = Instant::now();
    for _ in 0..10 {
        for angles in angles {
            black_box(sin_cos_all(*black_box(angles)));
        }
    }
    start.elapsed().as_secs_f64() * 1e9 / (10 * CALLS) as f64
}

#[inline]
fn one_by_one<T: Copy, const N: usize>(
    angles: [T; N],
    sin_cos: impl Fn(T) -> (T, T),
) -> Pair<T, N> {
    let pairs = angles.map(sin_cos);
    (pairs.map(|(sine, _)| sine), pairs.map(|(_, cosine)| cosine))
}

/// Joint angles between −π and π, in an order without a pattern.
fn angles<const N: usize>() -> [[f64; N]; CALLS] {
    let mut fraction = 0.5;
    from_fn(|_| {
        from_fn(|_| {
            fraction = (fraction + 0.618_033_988_749_894_8) % 1.0;
            (fraction - 0.5) * core::f64::consts::TAU
        })
    })
}

/// Prints the worst errors of single precision over all positive angles; negative ones mirror them.
fn exhaustive() {
    let mut worst = [(0.0, 0.0); 2];
    for bits in 0..f32::INFINITY.to_bits() {
        let angle = f32::from_bits(bits);
        let (sine, cosine) = single::sin_cos(angle);
        let (exact_sine, exact_cosine) = f64::from(angle).sin_cos();
        let errors = [error(sine, exact_sine), error(cosine, exact_cosine)];
        for (worst, error) in worst.iter_mut().zip(errors) {
            if error > worst.0 {
                *worst = (error, angle);
            }
        }
        if bits % (1 << 24) == 0 {
            eprint!("\r{} of 127", bits >> 24);
        }
    }
    let [(sine, at), (cosine, there)] = worst;
    println!("\rsine {sine:.4} ulp at {at:e}, cosine {cosine:.4} ulp at {there:e}");
}

/// Error in ulps of the exact value.
fn error(found: f32, exact: f64) -> f64 {
    let power_of_two = f64::from_bits(exact.to_bits() & f64::INFINITY.to_bits());
    let unit = (f64::from(f32::EPSILON) * power_of_two).max(f64::from(f32::from_bits(1)));
    (f64::from(found) - exact).abs() / unit
}

#[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
fn rounded(x: f64) -> f32 {
    x as f32
}
