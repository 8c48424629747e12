#!/usr/bin/env bash
# The package, from its sources to its tests: builds the wheel, installs it in a fresh environment with neither cargo nor a
# C compiler on the path, and runs the tests there.
#
#   test.sh [--libraries] [arguments of pytest]
#
# The wheel is compiled as it is published with --libraries, and otherwise in half of the time. With HOMOGEN_LONG=1 all
# functions of a floating quadruped are compared as well.
#
# Maturin, llvmlite, NumPy, pytest and mypy come from PyPI, crates from crates.io; with --libraries PyTorch, JAX, CasADi,
# SymPy, Numba, Pinocchio, MuJoCo, robotics-toolbox, matplotlib and Jupyter's kernel as well, of gigabytes, and only the tests
# of these run. Where there is no Python from 3.10 on with
# `venv`, the last line says so and nothing is checked.
set -euo pipefail
libraries=()
tests=()
profile=tested
if [ "${1:-}" = --libraries ]; then
    shift
    profile=release
    libraries=(casadi ipykernel jax matplotlib mujoco nbclient numba pin roboticstoolbox-python sympy torch)
    tests=(test_plain.py test_libraries.py test_pinocchio.py test_guide.py test_notebooks.py test_cuda.py)
fi
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! python3 -c 'import sys, ensurepip; assert sys.version_info >= (3, 10)' 2>/dev/null; then
    echo "not checked: there is no Python from 3.10 on with venv"
    exit 0
fi

. tests/homogen.sh
homogen="$(realpath "$homogen")"
folder="$(mktemp -d)"
rm="$(command -v rm)"
trap '"$rm" -rf "$folder"' EXIT

# With the same versions as the workspace; cargo drops what it does not need.
cp Cargo.lock python/Cargo.lock
python3 -m venv "$folder/build"
"$folder/build/bin/pip" install --quiet --disable-pip-version-check 'maturin>=1.9,<2'
"$folder/build/bin/maturin" build --quiet --profile "$profile" --manifest-path python/Cargo.toml --out "$folder/wheels"

python3 -m venv "$folder/python"
"$folder/python/bin/pip" install --quiet --disable-pip-version-check "$folder"/wheels/*.whl 'pytest>=7' mypy "${libraries[@]}"
# Beside Python there are the tools of a shell, and no others.
mkdir "$folder/bin"
for tool in dirname uname; do
    ln -s "$(command -v "$tool")" "$folder/bin/$tool"
done
cp -r python/tests "$folder/tests"
cd "$folder/tests"
HOMOGEN_LIBRARIES="$(IFS=, && echo "${libraries[*]}")"
export HOMOGEN_LIBRARIES PATH="$folder/python/bin:$folder/bin" HOMOGEN="$homogen" HOMOGEN_REPOSITORY="$OLDPWD" HOMOGEN_CACHE="$folder/cache"
python -c 'import shutil; assert not any(map(shutil.which, ["cargo", "rustc", "cc", "gcc", "clang"]))'
python -m pytest -q -W error -W ignore::homogen.DescriptionWarning "$@" "${tests[@]}"
