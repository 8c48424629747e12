# Pinocchio and CasADi, and the C that they make of a robot. For other scripts, which source it.
#
# Packages for Python come from PyPI; PEER_VENV names a virtual environment in which to keep them.

peer_room="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

# Pinocchio's own limits, without which its headers do not compile.
peer_templates=(-std=c++17 -w -DNDEBUG -DBOOST_MPL_LIMIT_LIST_SIZE=30
    -DBOOST_MPL_LIMIT_VECTOR_SIZE=30 -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS
    -DBOOST_FUSION_INVOKE_MAX_ARITY=12)

peer_stale() { # file others: whether it is missing, or older than one of the others
    local file="$1" other
    shift
    [ -e "$file" ] || return 0
    for other; do
        if [ "$other" -nt "$file" ]; then return 0; fi
    done
    return 1
}

peer_tools() { # folder: the packages, and in the folder the generator; says where in peer_…
    local packages
    peer_venv="${PEER_VENV:-$1/venv}"
    peer_generator="$1/generate"
    mkdir -p "$1"
    [ -x "$peer_venv/bin/python" ] || python3 -m venv "$peer_venv"
    "$peer_venv/bin/pip" install --quiet --disable-pip-version-check -r "$peer_room/requirements.txt"
    packages=$("$peer_venv/bin/python" -c 'import sysconfig; print(sysconfig.get_paths()["purelib"])')
    peer_templates+=(-isystem "$packages/cmeel.prefix/include"
        -isystem "$packages/cmeel.prefix/include/eigen3")
    if peer_stale "$peer_generator" \
        "$peer_room"/{generate{,_derivatives}.cpp,{generate,model,second_moments}.hpp,requirements.txt}; then
        printf '=== the generator, which takes minutes to compile\n' >&2
        g++ -O1 "${peer_templates[@]}" -isystem "$packages/casadi/include" \
            "$peer_room"/generate{,_derivatives}.cpp -L "$packages/casadi" -lcasadi \
            "-Wl,-rpath,$packages/casadi" -o "$peer_generator"
    fi
}

peer_model() { # urdf frame file [fixed | floating]: the numbers of a robot
    "$peer_venv/bin/python" "$peer_room/model.py" "$@"
}

# CasADi writes one file a function: as they are, in `plain`; with right angles made exact and common
# parts merged, in `snapped`; and those rid of a check for null at every number that is read or
# written, in `restrict`. It calls the sines of double precision whatever its numbers are.
peer_generate() { # model real folder [functions]
    local how
    for how in plain snapped; do
        mkdir -p "$3/$how"
        "$peer_generator" "$1" "$3/$how" "$2" "$how" "${@:4}"
        [ "$2" = double ] || sed -i -E 's/\b(sin|cos|sqrt)\(/\1f(/g' "$3/$how"/*.c
    done
    mkdir -p "$3/restrict"
    cp "$3/snapped"/*.c "$3/restrict"
    sed -i -E \
        -e 's/arg\[([0-9]+)\]\? arg\[[0-9]+\]\[([0-9]+)\] : 0/in\1[\2]/' \
        -e 's/if \(res\[0\]!=0\) res\[0\]\[/out[/' \
        -e '/^static int casadi_f0\(.*\{$/a\
  const casadi_real *restrict in0 = arg[0], *restrict in1 = arg[1], *restrict in2 = arg[2];\
  casadi_real *restrict out = res[0];' "$3/restrict"/*.c
}
