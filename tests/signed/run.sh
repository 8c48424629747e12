#!/usr/bin/env bash
# Tests generated files of some shipped robots (all with --long), in f32 and f64, in Rust and in C, with fields and in
# ASCII: each is formatted as by rustfmt, passes its own tests, and is reproduced byte for byte by the command in its
# head. A file with a wrong digit fails its tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

. tests/homogen.sh
folder="$built/signed"
rm -rf "$folder"
mkdir -p "$folder"
warnings=(-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -O1 -ffp-contract=off)

fail() { echo "$*" >&2; exit 1; }

again() { # file, robot: compares the file with the output of the command in its head
    local command
    command=$(sed -n 's#^\(//\| \*\) Made by `\(.*\)` (FNV-1a [0-9a-f]*), in format [0-9]*\.$#\2#p' "$1" | head -n 1)
    [ -n "$command" ] || fail "$1 has no command in its head"
    eval "set -- \"$1\" \"$2\" $command"
    local file="$1" robot="$2"
    shift 5 # with the name of the robot's file, which is not in this folder
    mkdir -p "$folder/again"
    (cd "$folder/again" && "$homogen" generate "$robot" "$@" 2>/dev/null >stdout)
    case "$file" in
    *.rs) cmp "$file" "$folder/again/stdout" ;;
    *) cmp "$file" "$folder/again/$(basename "$file")" && cmp "${file%.c}.h" "$folder/again/$(basename "${file%.c}").h" ;;
    esac
}

rust() { # file: runs its tests
    rustfmt --check --edition 2021 "$1"
    rustc --test --edition 2021 -D warnings -C debuginfo=0 -C codegen-units=4 -o "${1%.rs}.test" "$1"
    "${1%.rs}.test" --quiet >"${1%.rs}.log"
}

c() { # file, prefix: runs its tests
    printf '#include "%s"\nint main(void) { return %sself_test() != 0; }\n' "$(basename "${1%.c}").h" "$2" >"${1%.c}_main.c"
    cc "${warnings[@]}" -DHOMOGEN_SELF_TEST "$1" "${1%.c}_main.c" -o "${1%.c}.test" -lm
    "${1%.c}.test"
}

files=0
one() { # name, robot, options: all files of a robot, in Rust and C, one in f32 and the other in f64, alternating
    local name="$1" robot="$2" scalars=(f32 f64) rust c
    shift 2
    rust="$folder/${name}_${scalars[files / 2 % 2]}.rs"
    c="$folder/${name}_${scalars[(files / 2 + 1) % 2]}.c"
    "$homogen" generate "$robot" --scalar "${scalars[files / 2 % 2]}" "$@" -o "$rust" 2>/dev/null
    again "$rust" "$robot"
    rust "$rust"
    "$homogen" generate "$robot" --scalar "${scalars[(files / 2 + 1) % 2]}" "$@" --extern-c arm_ --language c -o "$c" 2>/dev/null
    again "$c" "$robot"
    c "$c" arm_
    files=$((files + 2))
}

one two_link "$PWD/robots/two_link.urdf" --ascii
! LC_ALL=C grep -n '[^ -~]' "$folder"/two_link_*.rs "$folder"/two_link_*.[ch] || fail "a character beyond ASCII"
robots=(robots/scara.urdf robots/ur5_class.urdf robots/stanford_class.dh)
[ "${1:-}" != --long ] || robots=(robots/*.urdf robots/*.dh)
for robot in "${robots[@]}"; do
    [ -e "$robot" ] || continue
    name=$(basename "${robot%.*}")
    [ "$name" = two_link ] || one "$name" "$PWD/$robot"
done
one fields "$PWD/robots/two_link.urdf" --tip tip --field load=payload_on:tip --range load=0..4 --field g=gravity \
    --field c=com_of:fore --prepare --functions inverse_dynamics+mass_matrix,gravity,kinetic_energy
one floating "$PWD/robots/quadruped.urdf" --floating --external hr_foot --functions inverse_dynamics,bias
one every_joint "$PWD/tests/robots/every_joint.urdf" --tip link_geared \
    --functions forward_kinematics,body_jacobian_rate,inverse_dynamics,mass_matrix,base_regressor
one every_joint_floating "$PWD/tests/robots/every_joint.urdf" --floating --functions inverse_dynamics,mass_matrix,gravity_derivative
one two_arms "$PWD/tests/robots/two_arms.urdf" --collision=left_hand:right_hand --collision=stand:right_hand \
    --functions sphere_centers,distances,distance_jacobian
one humanoid "$PWD/tests/robots/humanoid.urdf" --tip left_arm_9 --functions inverse_dynamics,mass_matrix,gravity

# The tests find a wrong digit in the middle of a number, which a reviewer would overlook.
for file in "$folder"/two_link_*.rs "$folder"/two_link_*.c; do
    [[ $file != *_main.c ]] || continue
    changed="${file%.*}_changed.${file##*.}"
    sed 's/0\.0325/0.0326/' "$file" >"$changed"
    ! cmp -s "$file" "$changed" || fail "no digit to change in $file"
    case "$changed" in
    *.rs) ! (rust "$changed") 2>/dev/null || fail "a wrong digit passes in Rust" ;;
    *)
        cp "${file%.c}.h" "${changed%.c}.h"
        ! (c "$changed" arm_) || fail "a wrong digit passes in C"
        ;;
    esac
done
echo "$files files: tests pass, and the commands in their heads reproduce them"
