#!/usr/bin/env bash
# Expands the xacro files of some repositories, and random expressions; compares each with ROS's tool.
#
#   xacro.sh                in a temporary folder, with 20 000 expressions
#   xacro.sh FOLDER         keeps downloads in FOLDER for the next run; uses the checkouts in FOLDER/robots
#   xacro.sh FOLDER COUNT   with COUNT expressions, without the report
#
# Clones the repositories of xacro_robots.txt (some gigabytes), installs the tool from PyPI, builds `homogen`, and writes
# its sections of report/ZOO.md. Fails if an expansion or a value differs, if only one of both rejects a file, and if a
# command takes more than a minute.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

environment xacro xacro==2.1.1 PyYAML==6.0.4

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
done < <(listed xacro_robots.txt)

homogen

report=()
[ $# -gt 1 ] || report=(--report "$root/report/ZOO.md")
say "expressions"
"$python" "$here/xacro_expressions.py" "$binary" --count "${2:-20000}" "${report[@]}"
say "files"
"$python" "$here/xacro_peer.py" "$binary" "$folder/robots" "$here/xacro_arguments.txt" "${report[@]}"
