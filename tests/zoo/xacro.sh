#!/usr/bin/env bash
# Expands the xacro files of some repositories, and random expressions; compares each with ROS's tool.
#
#   xacro.sh                in a temporary folder, with 20 000 expressions
#   xacro.sh FOLDER         keeps downloads in FOLDER for the next run; uses the checkouts in FOLDER/robots
#   xacro.sh FOLDER COUNT   with COUNT expressions
#
# Clones the repositories of xacro_robots.txt (some gigabytes), installs the tool from PyPI, and builds `homogen`. Fails
# if an expansion or a value differs, if only one of both rejects a file, and if a command takes more than a minute.
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
    say "xacro"
    python3 -m venv "$folder/venv"
    "$python" -m pip install --quiet --disable-pip-version-check xacro==2.1.1 PyYAML==6.0.4
    touch "$folder/venv/complete"
fi

mkdir -p "$folder/robots"
while read -r repository commit; do
    to="$folder/robots/${repository/\//+}"
    [ -d "$to" ] && continue
    say "$repository"
    rm -rf "$to.part"
    git init --quiet "$to.part"
    git -C "$to.part" fetch --quiet --depth 1 "https://github.com/$repository" "$commit"
    git -C "$to.part" checkout --quiet FETCH_HEAD
    mv "$to.part" "$to"
done < <(grep -v '^#' "$here/xacro_robots.txt")

say "homogen"
cargo build --quiet --release --locked --manifest-path "$root/Cargo.toml" -p homogen-cli --bin homogen
binary="${CARGO_TARGET_DIR:-$root/target}/release/homogen"

say "expressions"
"$python" "$here/xacro_expressions.py" "$binary" --count "${2:-20000}"
say "files"
"$python" "$here/xacro_peer.py" "$binary" "$folder/robots" "$here/xacro_arguments.txt"
