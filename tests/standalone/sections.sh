#!/usr/bin/env bash
# Compares functions split into sections with the same functions unsplit, bit for bit at random states, in Rust and in
# C, for a chain of 32 joints; compiles them with the oldest compiler version stated in their head.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

folder="${CARGO_TARGET_DIR:-$PWD/target}/standalone/sections"
mkdir -p "$folder"

cargo build --quiet --locked -p homogen-cli --bin homogen --example sizes
built="${CARGO_TARGET_DIR:-target}/debug"
"$built/examples/sizes" --robot chain 32 >"$folder/chain.urdf"
generate() { "$built/homogen" generate "$folder/chain.urdf" --functions inverse_dynamics,mass_matrix "$@"; }
generate --scalar f64 --name Chain --section 1000000 -o "$folder/whole.rs"
generate --scalar f64 --name Chain -o "$folder/chosen.rs"
generate --scalar f64 --name Chain --section 300 -o "$folder/short.rs"
generate --language c --extern-c chain_ --section 1500 -o "$folder/chain.c"
if grep -q 'fn section_' "$folder/whole.rs"; then
    echo "a function within the limit was split into sections" >&2
    exit 1
fi
grep -q 'fn section_5(' "$folder/chosen.rs"
grep -q 'fn section_30(' "$folder/short.rs"
grep -q 'static CHAIN_APART void chain_mass_matrix_section_5(' "$folder/chain.c"

cat >"$folder/main.rs" <<'RUST'
mod whole { include!("whole.rs"); }
mod chosen { include!("chosen.rs"); }
mod short { include!("short.rs"); }
type Q = [f64; 32];
extern "C" {
    fn chain_inverse_dynamics(q: *const f64, qd: *const f64, qdd: *const f64, tau: *mut f64);
    fn chain_mass_matrix(q: *const f64, m: *mut f64);
}
fn main() {
    let mut seed = 1_u64;
    let mut unit = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let bits = |found: Q| -> [u64; 32] { found.map(f64::to_bits) };
    for _ in 0..200 {
        let [q, qd, third]: [Q; 3] = [[(); 32].map(|()| unit()), [(); 32].map(|()| unit()), [(); 32].map(|()| unit())];
        let (mut torques_c, mut matrix_c) = ([0.0; 32], [[0.0; 32]; 32]);
        let [q_c, qd_c, third_c] = [q.as_ptr(), qd.as_ptr(), third.as_ptr()];
        unsafe {
            chain_inverse_dynamics(q_c, qd_c, third_c, torques_c.as_mut_ptr());
            chain_mass_matrix(q_c, matrix_c.as_mut_ptr().cast());
        }
        let torques = bits(whole::Chain.inverse_dynamics(&q, &qd, &third));
        assert_eq!(torques, bits(chosen::Chain.inverse_dynamics(&q, &qd, &third)));
        assert_eq!(torques, bits(short::Chain.inverse_dynamics(&q, &qd, &third)));
        assert_eq!(torques, bits(torques_c));
        let matrix = whole::Chain.mass_matrix(&q).map(bits);
        assert_eq!(matrix, chosen::Chain.mass_matrix(&q).map(bits));
        assert_eq!(matrix, short::Chain.mass_matrix(&q).map(bits));
        assert_eq!(matrix, matrix_c.map(bits));
    }
    println!("sections: the same bits as unsplit functions at 200 states, in Rust and in C");
}
RUST
"${CC:-cc}" -std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -O2 -ffp-contract=off \
    -c "$folder/chain.c" -o "$folder/chain.o"
rustc --edition 2021 -O -D warnings -C link-arg="$folder/chain.o" -o "$folder/main" "$folder/main.rs"
"$folder/main"

version=$(sed -n 's|^// Needs: Rust \([0-9.]*\) or later.*|\1|p' "$folder/chosen.rs").0
rustc=(rustc)
if rustup run "$version" rustc --version >/dev/null 2>&1 ||
    rustup toolchain install "$version" --profile minimal >/dev/null 2>&1; then
    rustc=(rustup run "$version" rustc)
fi
for file in chosen short; do
    { echo '#![no_std]'; cat "$folder/$file.rs"; } >"$folder/$file.crate.rs"
    env -u RUST_MIN_STACK "${rustc[@]}" -C debuginfo=2 --edition 2018 --crate-type lib --crate-name sections \
        -D warnings -o "$folder/$file.rlib" "$folder/$file.crate.rs"
done
echo "sections: machine code by $("${rustc[@]}" --version)"
