#!/usr/bin/env bash
# Compiles headers in C++17 with many warnings and compares their functions with those of the C file, bit for bit: of
# double and float, of arrays of C, std::array, std::vector and Eigen, and of twists in both orders; and compares
# derivatives by a dual number.
#
# Needs Python 3 and a compiler of C and C++; where Clang and Eigen are installed they are checked, too. Without a compiler
# nothing is checked and the last line says so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

if ! c++ --version >/dev/null 2>&1 || ! cc --version >/dev/null 2>&1; then
    echo "not checked: there is no C++ compiler"
    exit 0
fi

. tests/homogen.sh
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
twists="geometric_jacobian,body_jacobian,spatial_jacobian,velocity,jacobian_derivative,centroidal_momentum_matrix"
robots=(
    "robots/two_link.urdf --field payload=mass_of:fore --field lift=gravity --functions gravity,gravity_derivative,inverse_dynamics,forward_dynamics,mass_matrix+bias,kinetic_energy,inverse_dynamics_hessian,forward_kinematics"
    "robots/ur5_class.urdf --functions gravity,gravity_derivative,inverse_dynamics,inverse_dynamics_derivatives,geometric_jacobian,regressor --friction --friction=elbow=0.2"
    "robots/quadruped.urdf --floating --tip fl_foot --external fl_foot --functions inverse_dynamics,mass_matrix,forward_dynamics"
    "tests/robots/two_arms.urdf --floating --collision=left_hand:right_hand --collision=stand:right_hand --functions sphere_centers,distances,distance_jacobian"
    "robots/two_link.urdf --formulation platform-sines --functions gravity,gravity_derivative"
    "robots/two_link.urdf --order linear-first --tip tip --external fore --functions $twists,inverse_dynamics,forward_dynamics,forward_kinematics_hessian"
    "robots/quadruped.urdf --order linear-first --floating --tip fl_foot --external fl_foot,hl_foot --functions $twists,inverse_dynamics"
    "robots/stanford_class.dh --scalar f32 --functions inverse_dynamics,body_jacobian"
)
python3 tests/cpp/compare.py "$homogen" "$folder" "${robots[@]}"
