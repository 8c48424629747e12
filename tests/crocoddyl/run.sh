#!/usr/bin/env bash
# Compares the optimal motion of the example `optimal_motion` with that of Crocoddyl: the same cost at the beginning, the
# same optimum; prints iterations and times of both.
#
# Crocoddyl and Pinocchio come from PyPI. Without Python with `venv`, nothing is checked and the last line says so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

if ! python3 -c 'import sys, ensurepip; assert sys.version_info >= (3, 10)' 2>/dev/null; then
    echo "not checked: there is no Python from 3.10 on with venv"
    exit 0
fi

cargo build --quiet --release -p homogen-examples --bin optimal_motion
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
# The wheel of Crocoddyl is built against this Pinocchio, and crashes with a later one.
"$folder/python/bin/pip" install --quiet --disable-pip-version-check \
    crocoddyl==3.2.1 pin==4.0.0 libpinocchio==4.0.0 numpy
"$folder/python/bin/python" -W error tests/crocoddyl/reach.py \
    "${CARGO_TARGET_DIR:-target}/release/optimal_motion"
