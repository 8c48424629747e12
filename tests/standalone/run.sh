#!/usr/bin/env bash
# Compiles files for `core` alone, without functions for C and with them, with the oldest compilers
# that their heads promise.
#
# rustup installs the compiler where it is missing. Where there is no rustup, or it cannot, the
# compiler that is there has to do, and the last line says which one it was.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

folder="${CARGO_TARGET_DIR:-$PWD/target}/standalone"
mkdir -p "$folder"

homogen() { cargo run --quiet --locked -p homogen-codegen --features cli --bin homogen -- "$@"; }

compiler() { # version: the command that is this compiler, or the one that there is
    if rustup run "$1" rustc --version >/dev/null 2>&1 ||
        rustup toolchain install "$1" --profile minimal >/dev/null 2>&1; then
        echo "rustup run $1 rustc"
    else
        echo rustc
    fi
}

compile() { # file: as the whole of a crate without a standard library
    local version rustc edition
    version=$(sed -n 's|^// Needs: Rust \([0-9.]*\) or later.*|\1|p' "$1")
    read -ra rustc <<<"$(compiler "$version.0")"
    { echo '#![no_std]'; cat "$1"; } >"$1.crate.rs"
    for edition in 2018 2021; do
        "${rustc[@]}" --edition "$edition" --crate-type lib --crate-name standalone -D warnings \
            --emit metadata -o "$1.rmeta" "$1.crate.rs"
    done
    echo "$(basename "$1"): promises Rust $version, compiles with $("${rustc[@]}" --version)"
}

for robot in panda_class:link8 scara:tool; do
    for scalar in f32 f64; do
        file="$folder/${robot%:*}_$scalar.rs"
        generate=(generate "robots/${robot%:*}.urdf" --tip "${robot#*:}" --scalar "$scalar")
        homogen "${generate[@]}" -o "$file"
        compile "$file"
        homogen "${generate[@]}" --extern-c arm_ --c-header "${file%.rs}.h" -o "${file%.rs}_c.rs"
        compile "${file%.rs}_c.rs"
    done
done
