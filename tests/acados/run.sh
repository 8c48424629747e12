#!/usr/bin/env bash
# Time steps in C, and acados' interface to them: compiled against the headers of acados and BLASFEO, called through the
# pointers that acados has, on vectors and matrices of BLASFEO. Values are compared with the rules written out, first and
# second derivatives with extrapolated differences.
#
#   run.sh                   clones acados and BLASFEO from GitHub
#   run.sh ACADOS BLASFEO    takes these clones
#
# Needs git, make and gcc.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
. tests/homogen.sh
homogen="$(realpath "$homogen")"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

acados="${1:-}" from="${2:-https://github.com/giaf/blasfeo}"
if [ -z "$acados" ]; then
    acados="$folder/acados"
    git clone --quiet --depth 1 https://github.com/acados/acados "$acados"
fi
# A clone of its own, since it is built there.
blasfeo="$folder/blasfeo"
git clone --quiet "$from" "$blasfeo"
make --silent -C "$blasfeo" TARGET=GENERIC static_library >/dev/null 2>&1

headers=(-isystem "$acados" -isystem "$blasfeo/include")
strict=(-std=c99 -Wall -Wextra -Wconversion -Wpedantic -Werror -O2 -ffp-contract=off)
functions=forward_dynamics,forward_dynamics_derivatives,forward_dynamics_hessian
shared=forward_dynamics,forward_dynamics+forward_dynamics_derivatives,forward_dynamics_hessian

check() { # robot, file, rule, options
    local name="$1" rule="$3"
    "$homogen" generate "$2" --language c --name "$name" --functions "$functions" --steps "$rule" --acados "${@:4}" \
        -o "$folder/$name.c" >/dev/null
    gcc "${strict[@]}" "${headers[@]}" -c "$folder/$name.c" -o "$folder/$name.o"
    g++ -x c++ -std=c++17 -Wall -Wextra -O0 "${headers[@]}" -c "$folder/$name.c" -o /dev/null
    gcc "${strict[@]}" "${headers[@]}" -I "$folder" -DHEADER="\"$name.h\"" -DROBOT="$name" "-DCOUNT=${name^^}_NV" \
        "-DRULE=${rule//-/_}" tests/acados/check.c "$folder/$name.o" "$blasfeo/lib/libblasfeo.a" -lm -o "$folder/check"
    echo -n "$name, $rule: "
    "$folder/check"
}

for rule in semi-implicit euler rk4; do
    check two_link robots/two_link.urdf "$rule"
    check scara robots/scara.urdf "$rule"
done
functions="$shared" check panda robots/panda_class.urdf rk4 --tip link8
check rubbing robots/two_link.urdf rk4 --damping shoulder=0.5
# Without acados steps may have fields and external wrenches, and numbers of f32.
"$homogen" generate robots/two_link.urdf --language c --functions "$functions" --steps rk4 --field payload=mass_of:fore \
    --external fore --scalar f32 -o "$folder/loaded.c" >/dev/null
gcc "${strict[@]}" -c "$folder/loaded.c" -o /dev/null
echo "steps and the interface of acados: all equal"
