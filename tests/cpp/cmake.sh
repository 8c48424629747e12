#!/usr/bin/env bash
# Builds the projects of `homogen new cmake` in C and C++, tests and installs them, and builds programs that find them by
# find_package and by add_subdirectory.
#
# CMake comes from PyPI. Without Python with `venv`, or without a compiler of C and C++, nothing is checked and the last
# line says so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

if ! python3 -c 'import ensurepip' 2>/dev/null; then
    echo "not checked: there is no Python with venv"
    exit 0
fi
if ! c++ --version >/dev/null 2>&1 || ! cc --version >/dev/null 2>&1 || ! make --version >/dev/null 2>&1; then
    echo "not checked: there is no C++ compiler, or no make"
    exit 0
fi

. tests/homogen.sh
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" install --quiet --disable-pip-version-check cmake==4.4.5
PATH="$folder/python/bin:$PATH"
export CFLAGS="-Wall -Wextra -Werror" CXXFLAGS="-Wall -Wextra -Wconversion -Werror" CMAKE_GENERATOR="Unix Makefiles"

cmake_quietly() { # arguments: shows what CMake says if it fails
    cmake "$@" >"$folder/log" 2>&1 || { cat "$folder/log" >&2 && exit 1; }
}

program() { # name, command of CMake that brings the package, its option: a program that prints a torque
    local own="$folder/$1-$3"
    mkdir -p "$own"
    cp "$folder/main.$ending" "$own/main.$ending"
    cat >"$own/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.14)
project(user LANGUAGES C CXX)
$2
add_executable(user main.$ending)
target_link_libraries(user PRIVATE $package::$package)
END
    cmake_quietly -S "$own" -B "$own/build" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=$folder/$1-installed"
    cmake_quietly --build "$own/build"
    "$own/build/user" >"$own/printed"
    grep -q "^-\?[0-9]" "$own/printed"
}

project() { # name, file, options
    local own="$folder/$1"
    "$homogen" new cmake "${@:2}" -o "$own" >/dev/null
    cmake_quietly -S "$own" -B "$own-build"
    cmake_quietly --build "$own-build"
    [ "$ending" = c ] || ctest --test-dir "$own-build" --no-tests=error >/dev/null
    cmake_quietly --install "$own-build" --prefix "$folder/$1-installed"
    program "$1" "find_package($package 0.1 REQUIRED)" installed
    program "$1" "add_subdirectory($own added)" added
    cmp "$folder/$1-installed/printed" "$folder/$1-added/printed"
    echo "$1: built, installed, found and added"
}

main() { # header, expression, its statements before: the program in both languages
    printf '#include <stdio.h>\n#include "%s"\nint main(void)\n{\n    %s\n    printf("%%.17g\\n", (double)(%s));\n    return 0;\n}\n' \
        "$1" "$3" "$2" >"$folder/main.$ending"
}

sed 's/<robot name="[^"]*"/<robot name="2nd test"/' robots/two_link.urdf >"$folder/named.urdf"
functions="--functions geometric_jacobian,gravity,inverse_dynamics"

ending=c package=two_link
main two_link.h "gravity[0]" "const double q[2] = {0.3, -0.7}; double gravity[2]; two_link_gravity(q, gravity);"
project c robots/two_link.urdf $functions
package=quadruped
main quadruped.h "gravity[0]" "double q[19], gravity[18]; quadruped_neutral(q); quadruped_gravity(q, gravity);"
project floating robots/quadruped.urdf --floating --functions gravity,forward_dynamics
package=panda_class
main panda_class.h "a[7][0]" "const double zero[7] = {0}; double q[7], qd[7], a[14][14], b[14][7]; panda_class_step_derivatives(zero, zero, zero, 0.001, q, qd, a, b);"
project steps robots/panda_class.urdf --tip link8 --steps rk4 --casadi --section 300 --functions forward_dynamics,forward_dynamics+forward_dynamics_derivatives
package=two_link ending=cpp
main two_link.hpp "two_link::gravity(q)[0]" "const std::array<double, 2> q = {0.3, -0.7};"
project cpp robots/two_link.urdf --language cpp $functions
cmp "$folder/c-installed/printed" "$folder/cpp-installed/printed"
main two_link.hpp "two_link::geometric_jacobian(q)[0][0]" "const std::array<float, 2> q = {0.3f, -0.7f};"
project linear_first robots/two_link.urdf --language cpp --order linear-first --scalar f32 $functions
main two_link.hpp "two_link::gravity(two_link::Robot<>{2.0}, q)[0]" "const std::array<double, 2> q = {0.3, -0.7};"
project fields robots/two_link.urdf --language cpp --field payload=mass_of:fore --external fore --functions inverse_dynamics,gravity
package=2nd_test
main 2nd_test.hpp "n2nd_test::NEUTRAL[0]" ""
project named "$folder/named.urdf" --language cpp --functions inverse_dynamics
