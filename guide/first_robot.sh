#!/usr/bin/env bash
# What the chapter on a first robot says, done by the letter: its commands, its files, its output.
# Needs cargo, and what the engine depends on in cargo's cache or in reach.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
chapter=$root/guide/src/first-robot.md
export CARGO_TARGET_DIR=$root/target/first_robot

# The block of code behind a mark of that name.
block() {
    awk -v mark="<!-- first robot: $1 -->" '
        $0 == mark { found = 1; next }
        found && /^```/ { if (inside) exit; inside = 1; next }
        inside { print }
    ' "$chapter"
}

folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
ln -s "$root" homogen
block commands >commands
bash -euo pipefail commands 2>/dev/null
cd arm
cp "$root/Cargo.lock" . # the same versions as here; cargo drops what it does not need

block Cargo.toml | diff - Cargo.toml # which the commands have made
block src/main.rs >src/main.rs
cargo run --quiet >printed
block output | diff - printed
echo "the first robot prints what the guide says"
