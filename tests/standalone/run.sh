#!/usr/bin/env bash
# Compiles files for `core`, without and with functions for C, with the oldest compiler version stated in their heads.
# Then compiles functions of many thousand operations to machine code with debug information: a compiler that visits
# them recursively could overflow its stack.
#
# With `--long` these are all functions, which takes minutes; by default only the longest ones that controllers call.
#
# rustup installs the compiler if it is missing. Without rustup, or if it fails, the installed compiler is used; the
# output states its version.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

. tests/homogen.sh
folder="$built/standalone"
mkdir -p "$folder"

compiler() { # version: the command for this compiler, or for the installed one
    if rustup run "$1" rustc --version >/dev/null 2>&1 ||
        rustup toolchain install "$1" --profile minimal >/dev/null 2>&1; then
        echo "rustup run $1 rustc"
    else
        echo rustc
    fi
}

minimum() { # file: the oldest compiler version, stated in its head
    sed -n 's|^// Needs: Rust \([0-9.]*\) or later.*|\1|p' "$1"
}

as_crate() { # file: writes it as a crate without the standard library
    { echo '#![no_std]'; cat "$1"; } >"$1.crate.rs"
}

compile() { # file: compiles it as a crate without the standard library
    local version rustc edition
    version=$(minimum "$1")
    read -ra rustc <<<"$(compiler "$version.0")"
    as_crate "$1"
    for edition in 2018 2021; do
        "${rustc[@]}" --edition "$edition" --crate-type lib --crate-name standalone -D warnings \
            --emit metadata -o "$1.rmeta" "$1.crate.rs"
    done
    echo "$(basename "$1"): needs Rust $version, compiles with $("${rustc[@]}" --version)"
}

build() { # file, compiler: unoptimised with full debug information, and optimised with line tables
    local file="$1" flags
    shift
    as_crate "$file"
    # With the default stack size of compilers. `debuginfo=1` includes `line-tables-only`, which older compilers lack.
    for flags in "-C debuginfo=2" "-C opt-level=3 -C debuginfo=1"; do
        read -ra flags <<<"$flags"
        env -u RUST_MIN_STACK "$@" "${flags[@]}" --edition 2021 --crate-type lib \
            --crate-name standalone -D warnings -o "$file.rlib" "$file.crate.rs"
    done
    echo "$(basename "$file"): machine code by $("$@" --version)"
}

for robot in panda_class:link8 scara:tool; do
    for scalar in f32 f64; do
        file="$folder/${robot%:*}_$scalar.rs"
        generate=(generate "robots/${robot%:*}.urdf" --tip "${robot#*:}" --scalar "$scalar")
        "$homogen" "${generate[@]}" -o "$file"
        compile "$file"
        "$homogen" "${generate[@]}" --extern-c arm_ --c-header "${file%.rs}.h" -o "${file%.rs}_c.rs"
        compile "${file%.rs}_c.rs"
    done
done

functions=(--functions inverse_dynamics,mass_matrix,mass_matrix_inverse,forward_dynamics)
[ "${1:-}" != --long ] || functions=()
for scalar in f32 f64; do
    file="$folder/humanoid_$scalar.rs"
    "$homogen" generate tests/robots/humanoid.urdf --tip left_arm_9 --scalar "$scalar" "${functions[@]}" -o "$file"
    build "$file" rustc
done
read -ra rustc <<<"$(compiler "$(minimum "$file").0")"
build "$file" "${rustc[@]}"

tests/standalone/sections.sh
