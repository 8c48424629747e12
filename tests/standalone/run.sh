#!/usr/bin/env bash
# Compiles files for `core` alone, without functions for C and with them, with the oldest compilers
# that their heads promise; then functions of many thousand operations, by which a compiler that goes
# through a function by recursion runs out of stack, as machine code with what debuggers need.
#
# With `--long` these are all functions, for minutes; without, the longest of those that controllers call.
#
# rustup installs the compiler where it is missing. Where there is no rustup, or it cannot, the
# compiler that is there has to do, and the last line says which one it was.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

. tests/homogen.sh
folder="$built/standalone"
mkdir -p "$folder"

compiler() { # version: the command that is this compiler, or the one that there is
    if rustup run "$1" rustc --version >/dev/null 2>&1 ||
        rustup toolchain install "$1" --profile minimal >/dev/null 2>&1; then
        echo "rustup run $1 rustc"
    else
        echo rustc
    fi
}

promised() { # file: the oldest compiler that its head names
    sed -n 's|^// Needs: Rust \([0-9.]*\) or later.*|\1|p' "$1"
}

as_crate() { # file: the same without a standard library
    { echo '#![no_std]'; cat "$1"; } >"$1.crate.rs"
}

compile() { # file: as the whole of a crate without a standard library
    local version rustc edition
    version=$(promised "$1")
    read -ra rustc <<<"$(compiler "$version.0")"
    as_crate "$1"
    for edition in 2018 2021; do
        "${rustc[@]}" --edition "$edition" --crate-type lib --crate-name standalone -D warnings \
            --emit metadata -o "$1.rmeta" "$1.crate.rs"
    done
    echo "$(basename "$1"): promises Rust $version, compiles with $("${rustc[@]}" --version)"
}

build() { # file, compiler: unoptimised with all of it, and optimised with the lines of the source
    local file="$1" flags
    shift
    as_crate "$file"
    # With the stack that compilers have by default. `debuginfo=1` has what `line-tables-only` has,
    # which the older ones don't know.
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
read -ra rustc <<<"$(compiler "$(promised "$file").0")"
build "$file" "${rustc[@]}"

tests/standalone/sections.sh
