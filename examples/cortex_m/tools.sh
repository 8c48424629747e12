# The tools of the scripts in this folder: missing ones are listed in `packages`, for `install` to install.
#
# In: the target, in `target`. Out: `cargo` and `rustc` as commands that compile for it, with `build_std`, the options
# by which the first builds `core` where rustup has no such target and Debian's compiler has to do.
# shellcheck shell=bash disable=SC2034,SC2154

say() { printf '%s\n' "$*" >&2; }
has() { command -v "$1" >/dev/null; }

install() {
    if [ "$(id -u)" != 0 ] || ! has apt-get; then
        say "missing: $*. It installs them on Debian, as root; here, please do it by hand."
        exit 2
    fi
    say "=== install $*"
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "$@" >/dev/null
}

packages=()
has qemu-system-arm || packages+=(qemu-system-arm)
has arm-none-eabi-objdump || packages+=(binutils-arm-none-eabi)
has arm-none-eabi-gcc || packages+=(gcc-arm-none-eabi)
cargo=(cargo)
rustc=(rustc)
build_std=()
linker="CARGO_TARGET_${target//-/_}_LINKER"
if ! { has rustup && { rustup target list --installed | grep -qx "$target" ||
    rustup target add "$target" >/dev/null 2>&1; }; }; then
    # Debian's compiler has the sources of `core`: options let it build them, with the linker of the tools above.
    { [ -x /usr/bin/rustc ] && [ -d /usr/lib/rustlib/src/rust/library ]; } ||
        packages+=(rustc-web cargo-web rust-web-src)
    cargo=(env RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc "${linker^^}=arm-none-eabi-ld" /usr/bin/cargo)
    rustc=(/usr/bin/rustc)
    build_std=(-Zbuild-std=core)
fi
