# What the scripts of this folder share: `. setup.sh`, then `environment`; both need `set -euo pipefail`.
#
# In: the arguments of the script, of which the first may be a folder for downloads. Out: the folders `here`, `root` and
# `folder`, and the functions below.
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$here/../.." && pwd)"

if [ $# -gt 0 ]; then
    mkdir -p "$1"
    folder="$(cd "$1" && pwd)"
else
    folder="$(mktemp -d)"
    trap 'rm -rf "$folder"' EXIT
fi
python="$folder/venv/bin/python"

say() { printf '=== %s\n' "$*" >&2; }

environment() { # name, arguments of pip: an environment of Python with a peer, made once
    [ -f "$folder/venv/complete" ] && return
    say "$1"
    python3 -m venv "$folder/venv"
    "$python" -m pip install --quiet --disable-pip-version-check "${@:2}"
    touch "$folder/venv/complete"
}

listed() { # file: its lines without comments
    grep -v '^#' "$here/$1"
}

homogen() { # builds the program; its path is in `binary`
    say "homogen"
    cargo build --quiet --release --locked --manifest-path "$root/Cargo.toml" -p homogen-cli --bin homogen
    binary="${CARGO_TARGET_DIR:-$root/target}/release/homogen"
}
