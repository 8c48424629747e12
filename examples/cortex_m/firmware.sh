#!/usr/bin/env bash
# Makes a new firmware for each of three robots and runs it under QEMU: it must print, to the last digit, the torques of
# `homogen eval` for the configuration of the robot.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

target=thumbv7em-none-eabihf
. ./tools.sh
[ ${#packages[@]} = 0 ] || install "${packages[@]}"

home=$(cd ../.. && pwd)
cd "$home"
. tests/homogen.sh
temporary=$(mktemp -d)
trap 'rm -rf "$temporary"' EXIT
# Built once for all three.
export CARGO_TARGET_DIR="$built/firmware"

numbers() { # the numbers of a text, one a line, as awk reads them
    grep -oE -- '-?[0-9]+\.?[0-9]*(e-?[0-9]+)?' | awk '{ printf "%.9g\n", $1 + 0 }'
}

one() { # robot, options: its firmware, and what it prints
    local robot="$1" folder found expected start
    shift
    folder="$temporary/$(basename "${robot%.*}")"
    "$homogen" new firmware "$robot" --homogen "$home" -o "$folder" "$@" >/dev/null
    ! "$homogen" new firmware "$robot" --homogen "$home" -o "$folder" "$@" 2>/dev/null ||
        { say "a folder is written over"; return 1; }
    found=$(cd "$folder" && timeout 170 "${cargo[@]}" run --quiet --release "${build_std[@]}" </dev/null | numbers)
    start=$(sed -n 's/^const START: .* = \(.*\);$/\1/p' "$folder/src/main.rs")
    printf '{"states":[{"q":%s}]}' "$start" >"$folder/start.json"
    expected=$("$homogen" eval "$robot" "$@" --function gravity --scalar f32 --format json \
        --states "$folder/start.json" | sed -n '/"results"/,$p' | numbers)
    [ -n "$expected" ] && [ "$found" = "$expected" ] ||
        { say "$robot: the firmware prints"; say "$found"; say "and not"; say "$expected"; return 1; }
    say "$(basename "$robot"): $(wc -l <<<"$found") torques are those of homogen eval"
}

one "$home/robots/panda_class.urdf" --tip link8
one "$home/robots/rx90_class.dh"
# Hostile names, and a floating base, whose q is longer than q̇.
sed 's/<robot name="[^"]*"/<robot name="..\/a\&quot;]\&#10;#{}\\"/' "$home/robots/two_link.urdf" >"$temporary/hostile.urdf"
one "$temporary/hostile.urdf" --floating --tip tip
