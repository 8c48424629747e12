#!/usr/bin/env bash
# Builds the WebAssembly module of the site, and writes its path to standard output.
#
# Needs cargo with the target wasm32-unknown-unknown, which rustup fetches; where it cannot, Debian's compiler with the
# sources of the standard library, and LLVM's linker, which the script installs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { printf '%s\n' "$*" >&2; }
has() { command -v "$1" >/dev/null; }

target=wasm32-unknown-unknown
built="${CARGO_TARGET_DIR:-$PWD/target}/site"
cargo=(cargo)
build_std=()
if ! { has rustup && { rustup target list --installed | grep -qx "$target" ||
    timeout 60 rustup target add "$target" >/dev/null 2>&1; }; }; then
    packages=()
    { [ -x /usr/bin/rustc ] && [ -d /usr/lib/rustlib/src/rust/library ]; } ||
        packages+=(rustc-web cargo-web rust-web-src)
    has wasm-ld-19 || packages+=(lld-19)
    if [ ${#packages[@]} -gt 0 ]; then
        if [ "$(id -u)" != 0 ] || ! has apt-get; then
            say "missing: the target $target of Rust. With rustup: rustup target add $target"
            exit 2
        fi
        say "=== install ${packages[*]}"
        apt-get update -qq
        DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${packages[@]}" >/dev/null
    fi
    cargo=(env RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld-19 /usr/bin/cargo)
    build_std=("-Zbuild-std=std,panic_abort")
fi

# The same versions as in the workspace; cargo drops what it does not need.
cp Cargo.lock site/Cargo.lock
CARGO_TARGET_DIR="$built" CARGO_PROFILE_RELEASE_DEBUG=0 "${cargo[@]}" build --release --target "$target" \
    --manifest-path site/Cargo.toml "${build_std[@]}" >&2
printf '%s\n' "$built/$target/release/homogen.wasm"
