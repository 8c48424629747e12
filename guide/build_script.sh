#!/usr/bin/env bash
# What the chapter on build scripts says, done by the letter.
# Needs cargo, and what the engine depends on in cargo's cache or in reach.
set -euo pipefail
chapter=build-script.md mark="build script"
. "$(dirname "${BASH_SOURCE[0]}")/letter.sh"

bash -euo pipefail commands 2>/dev/null
cd arm
cp "$root/Cargo.lock" . # the same versions as here; cargo drops what it does not need
block Cargo.toml | diff - Cargo.toml # which the commands have made
files build.rs src/main.rs
prints cargo run --quiet
