#!/usr/bin/env bash
# Tests Python packages: writes them, builds them with `pip` in a fresh virtual environment, and compares their results
# with `homogen eval`, bit for bit.
#
#   run.sh [--long]     --long: all functions of an arm with seven joints, not only seven functions
#
# Maturin and NumPy come from PyPI, the crates that a package needs from crates.io. Without Python 3.10 or later with
# `venv`, nothing is checked and the last line says so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

if ! python3 -c 'import sys, ensurepip; assert sys.version_info >= (3, 10)' 2>/dev/null; then
    echo "not checked: there is no Python from 3.10 on with venv"
    exit 0
fi

name=python
. tests/python/packages.sh
# Shared dependencies are compiled once.
export CARGO_TARGET_DIR="$folder/target"

# All functions of seven joints take two minutes to compile.
panda="--functions forward_kinematics,geometric_jacobian,acceleration,inverse_dynamics,mass_matrix,forward_dynamics,gravity_derivative"
[ "${1:-}" = --long ] && panda=""

# Module, description, options.
packages=(
    "panda_py robots/panda_class.urdf --tip link8 $panda"
    "two_link_py robots/two_link.urdf --scalar f32 --frames fore"
    "pushed_py robots/two_link.urdf --functions inverse_dynamics_derivatives,forward_dynamics,mass_matrix+inverse_dynamics_derivatives --external fore --friction=elbow=0.2 --damping shoulder=0.5"
    "quadruped_py robots/quadruped.urdf --floating --tip fl_foot --functions forward_kinematics,geometric_jacobian,inverse_dynamics,mass_matrix,forward_dynamics,centroidal_momentum_matrix,kinetic_energy --frames fr_foot,hl_foot"
    "class tests/python/hostile.urdf --functions forward_kinematics,body_jacobian,gravity,mass_matrix+gravity --frames __init__,init,import"
)
for package in "${packages[@]}"; do
    read -ra words <<<"$package"
    "$homogen" python "${words[@]:1}" -o "$folder/${words[0]}" >/dev/null
    began=$SECONDS
    pip install "$folder/${words[0]}"
    echo "${words[0]}: built and installed in $((SECONDS - began)) s"
done
"$python" -W error tests/python/check.py "$homogen" "${packages[@]}"
