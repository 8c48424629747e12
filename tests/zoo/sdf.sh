#!/usr/bin/env bash
# Evaluates random SDF files by the command line; compares each number with Drake.
#
#   sdf.sh                in a temporary folder, with 500 random files
#   sdf.sh FOLDER         keeps downloads in FOLDER for the next run
#   sdf.sh FOLDER COUNT   with COUNT random files, without the report
#
# Installs Drake from PyPI, builds `homogen`, and writes its section of report/ZOO.md. Fails if a number differs, if only one
# of both reads a file, and if a command crashes or takes more than ten seconds.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

environment Drake drake==1.51.1 numpy==2.4.6

homogen

report=()
[ $# -gt 1 ] || report=(--report "$root/report/ZOO.md")
"$python" -W ignore "$here/sdf.py" "$binary" --random "${2:-500}" "${report[@]}"
