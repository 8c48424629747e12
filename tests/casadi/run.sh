#!/usr/bin/env bash
# Compares the external interface of CasADi in C files, and time steps in C, with CasADi's own derivatives of the same
# robots, and solves a trajectory of the Panda with both.
#
# CasADi, with IPOPT, comes from PyPI. Without Python with `venv`, or without a C compiler, nothing is checked and the last
# line says so.
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
"$folder/python/bin/pip" install --quiet --disable-pip-version-check casadi==3.8.2 numpy

dynamics="inverse_dynamics,inverse_dynamics_derivatives+mass_matrix,inverse_dynamics_hessian,bias,gravity,gravity_derivative"
dynamics="$dynamics,forward_dynamics,forward_dynamics_derivatives,forward_dynamics_hessian,potential_energy,center_of_mass,center_of_mass_jacobian"
frames="forward_kinematics,geometric_jacobian,velocity,acceleration"
robots=(
    "robots/two_link.urdf --field payload=mass_of:fore --field lift=gravity --functions $dynamics,$frames"
    "robots/panda_class.urdf --tip link8 --functions $dynamics,$frames,regressor"
    "robots/ur5_class.urdf --functions $dynamics --friction --damping=elbow=0.3"
    "robots/scara.urdf --functions $dynamics"
    "robots/stanford_class.dh --functions $dynamics --section 300"
    "robots/quadruped.urdf --tip fl_foot --functions $dynamics"
    "robots/quadruped.urdf --floating --tip fl_foot --functions inverse_dynamics,forward_kinematics,inverse_dynamics_derivatives,mass_matrix"
    "robots/quadruped.urdf --floating --frames base,fl_foot,hr_foot --functions frame_poses"
    "robots/two_link.urdf --external fore --functions inverse_dynamics,forward_dynamics,inverse_dynamics_derivatives,mass_matrix"
    "robots/two_link.urdf --functions inverse_dynamics,inverse_dynamics_derivatives,constraint,constraint_jacobian --loop"
    "robots/two_link.urdf --functions inverse_dynamics,bias,forward_dynamics,inverse_dynamics_vjp,forward_dynamics_vjp"
    "robots/panda_class.urdf --tip link8 --functions $dynamics,inverse_dynamics_vjp,forward_dynamics_vjp"
)
loop='pin: rod(0.5) { from: fore, to: base, at: xyz(0.3, 0, 0) }'
robots[9]="${robots[9]} '$loop'"
"$folder/python/bin/python" -W error tests/casadi/compare.py "$homogen" "$folder" "${robots[@]}"
"$folder/python/bin/python" -W error tests/casadi/trajectory.py "$homogen" "$folder"
"$folder/python/bin/python" -W error tests/casadi/steps.py "$homogen" "$folder"
