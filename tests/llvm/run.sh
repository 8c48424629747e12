#!/usr/bin/env bash
# Compares LLVM IR with the C file, bit for bit: every function of the shipped robots, compiled by `llvmlite` and by the
# C compiler, in f32 and f64, one state at a time and in vectors, at several strides.
#
#   run.sh [--long]     --long: all robots; by default an arm, a floating quadruped, loops and fields
#
# llvmlite and NumPy come from PyPI. Without Python with `venv`, or without a C compiler, nothing is checked and the
# last line says so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

if ! python3 -c 'import sys, ensurepip; assert sys.version_info >= (3, 10)' 2>/dev/null; then
    echo "not checked: there is no Python from 3.10 on with venv"
    exit 0
fi
if ! cc --version >/dev/null 2>&1; then
    echo "not checked: there is no C compiler"
    exit 0
fi

. tests/homogen.sh
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" install --quiet --disable-pip-version-check llvmlite numpy

short=(
    "robots/two_link.urdf --field payload=mass_of:fore --field lift=gravity"
    "robots/ur5_class.urdf"
    "robots/quadruped.urdf --floating --tip fl_foot --functions forward_kinematics,inverse_dynamics,mass_matrix_inverse,forward_dynamics,inverse_dynamics_derivatives"
    "robots/two_link.urdf --external fore --functions inverse_dynamics,forward_dynamics --friction=elbow=0.2"
    "robots/quadruped.urdf --floating --frames base,fl_foot,hr_foot --functions frame_poses"
    "tests/robots/two_arms.urdf --collision --functions sphere_centers,distances,distance_jacobian"
    "robots/two_link.urdf --formulation platform-sines --functions gravity"
    "robots/two_link.urdf --loop 'pin: rod(0.5) { from: fore, to: base, at: xyz(0.3, 0, 0) }' --functions constraint,constraint_jacobian,constrained_forward_dynamics"
)
long=(
    "robots/panda_class.urdf"
    "robots/puma560.urdf"
    "robots/puma560_general.urdf"
    "robots/rx90_class.dh"
    "robots/scara.urdf"
    "robots/stanford.urdf"
    "robots/stanford_class.dh"
    "robots/stanford_general.urdf"
    "robots/quadruped.urdf"
    "robots/quadruped.urdf --floating --section 500"
)
robots=("${short[@]}")
[ "${1:-}" = --long ] && robots+=("${long[@]}")
"$folder/python/bin/python" -W error tests/llvm/compare.py "$homogen" "$folder" "${robots[@]}"
