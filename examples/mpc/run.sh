#!/usr/bin/env bash
# Tests the controller on this machine, then runs the firmware on a Cortex-M7 under QEMU, which counts instructions.
#
#   run.sh              fails if the goal is not reached, or if the numbers are not those of README.md
#   run.sh --update     writes them to README.md
#
# Missing tools are installed as by ../cortex_m/run.sh. With another compiler than README.md names, numbers are not compared.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

target=thumbv7em-none-eabihf
. ../cortex_m/tools.sh
[ ${#packages[@]} = 0 ] || install "${packages[@]}"
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}"

cp ../../Cargo.lock Cargo.lock
"${cargo[@]}" test --quiet --lib >&2
flags="CARGO_TARGET_${target//-/_}_RUSTFLAGS"
env "${flags^^}=-C target-cpu=cortex-m7" "${cargo[@]}" build --quiet --release "${build_std[@]}" --target "$target" --bin mpc

seen="$CARGO_TARGET_DIR/seen.txt"
{
    "${rustc[@]}" --version | cut -d' ' -f1,2
    timeout 120 qemu-system-arm -machine mps2-an500 -icount shift=0 -nographic \
        -semihosting-config enable=on,target=native -kernel "$CARGO_TARGET_DIR/$target/release/mpc" </dev/null
} | tee "$seen"

pasted="$CARGO_TARGET_DIR/README.md"
{
    sed -n '1,/^<!-- seen -->/p' README.md
    printf '```text\n%s\n```\n' "$(cat "$seen")"
    sed -n '/^<!-- end of seen -->/,$p' README.md
} >"$pasted"
if [ "${1:-}" = --update ]; then
    cp "$pasted" README.md
elif grep -qxF "$(head -n 1 "$seen")" README.md; then
    diff -u README.md "$pasted" >&2 || { say "run.sh: numbers changed; if they should, run it with --update"; exit 1; }
else
    say "run.sh: README.md is of another compiler, and is not compared"
fi
