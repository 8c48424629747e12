#!/usr/bin/env bash
# Builds the firmware for two boards, runs it under QEMU and checks the results.
#
#   run.sh              fails on any difference from the committed results
#   run.sh --quick      the same of one arm on one board, without comparing tables
#   run.sh --update     updates expected results and the README's tables, and lowers the budget
#   run.sh --mutations  shows that a wrong literal, double precision and a path that panics are noticed
#   run.sh --peer       measures the C of CasADi for the same arms, and updates the README's table
#                       beside it; fetches Pinocchio and CasADi from PyPI, compiles for minutes, and
#                       is not part of the checks
#
# Missing tools are installed: the target by rustup if it has it, others by apt-get (as root, on Debian).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

mode="${1:-check}"
target=thumbv7em-none-eabihf
arms=(panda_class puma560)
declare -A urdf=([panda_class]=../../robots/panda_class.urdf [puma560]=../../robots/puma560.urdf)
declare -A tip=([panda_class]=link8 [puma560]=tool)
boards=(M4F M7)
declare -A machine=([M4F]=mps2-an386 [M7]=mps2-an500)
declare -A processor=([M4F]=cortex-m4 [M7]=cortex-m7)
# Options of GCC that keep the order of statements as written, in which few values are live. On the M7 an instruction
# for a product and a sum, each rounded, is faster; GCC uses it when it optimises for size.
declare -A optimised=([M4F]="-O2 -fno-tree-ter -fno-schedule-insns" [M7]="-Os -fno-tree-ter")
# The folder of memory.x, in the template of a firmware.
memory=../../page/src/firmware
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}"
seen="$CARGO_TARGET_DIR/seen"

# --- tools ----------------------------------------------------------------------------------------

. ./tools.sh
if [ "$mode" = --peer ]; then
    . ../../report/peer/tools.sh
    python3 -c 'import ensurepip' 2>/dev/null || packages+=(python3-venv)
    has g++ || packages+=(g++)
    [ -f "$(arm-none-eabi-gcc -print-file-name=libm.a 2>/dev/null)" ] ||
        packages+=(libnewlib-arm-none-eabi)
fi
[ ${#packages[@]} = 0 ] || install "${packages[@]}"

# --- one arm, one board ---------------------------------------------------------------------------

host() { # runs the host program for an arm
    ARM="$1" "${cargo[@]}" run --quiet --profile host --locked -p host -- "${@:2}"
}

build() { # arm board options: the images
    local flags="CARGO_TARGET_${target//-/_}_RUSTFLAGS"
    env "ARM=$1" "${flags^^}=-C target-cpu=${processor[$2]}" "${cargo[@]}" build --quiet --release \
        --locked "${build_std[@]}" --target "$target" -p controller --bins "${@:3}"
}

observe() { # image board folder: disassembles it and runs it
    local image="$CARGO_TARGET_DIR/$target/release/$1" folder="$3"
    mkdir -p "$folder"
    arm-none-eabi-nm --demangle --print-size --defined-only "$image" >"$folder/symbols"
    arm-none-eabi-objdump --disassemble --demangle "$image" >"$folder/code"
    emulate "$2" "$image" "$folder/log"
}

emulate() { # board image log: an instruction lasts 1 ns
    timeout 120 qemu-system-arm -machine "${machine[$1]}" -icount shift=0 -nographic \
        -semihosting-config enable=on,target=native -kernel "$2" >"$3" </dev/null ||
        { cat "$3" >&2; say "run.sh: the firmware on $1 failed"; return 1; }
}

# The output folder of the last build script of a package.
written_by() { # package, the messages of its build
    sed -n "/build-script-executed.*[#\/]$1[#@]/s/.*\"out_dir\":\"\([^\"]*\)\".*/\1/p"
}

call_from_c() { # arm board: a firmware in C has the bits of the host, with the arm in Rust and in C
    local folder="$seen/c/$1/$2" out flags="CARGO_TARGET_${target//-/_}_RUSTFLAGS"
    mkdir -p "$folder/c99"
    out=$(env "ARM=$1" "${flags^^}=-C target-cpu=${processor[$2]}" "${cargo[@]}" build --quiet \
        --release --locked "${build_std[@]}" --target "$target" -p c_caller \
        --message-format=json | written_by c_caller)
    host "$1" states >"$folder/states.h"
    sed -n 's/^pub static \([A-Z_]*\):.*/\1/p; /^    \[/p' "expected/$1.rs" |
        sed '/^COMPUTED_TORQUE/,/^MASS_MATRIX/{/^MASS_MATRIX/!d}' >"$folder/expected"
    firmware_in_c "$1" "$2" "$out" "$folder" -L "$CARGO_TARGET_DIR/$target/release" -larm

    # shellcheck disable=SC2086 # several words
    gcc_for "$2" ${optimised[$2]} -ffp-contract=off -Wconversion -Wdouble-promotion \
        -c "$out/c99/arm.c" -o "$folder/c99/arm.o"
    firmware_in_c "$1" "$2" "$out/c99" "$folder/c99" "$folder/c99/arm.o"
    # Not the firmware: after linking, constants among the instructions are not marked.
    arm-none-eabi-nm --print-size "$folder/c99/arm.o" >"$folder/c99/symbols"
    arm-none-eabi-objdump --disassemble "$folder/c99/arm.o" >"$folder/c99/code"
}

gcc_for() { # board options
    arm-none-eabi-gcc -std=c99 -Wall -Wextra -Wpedantic -Werror -ffreestanding -mthumb \
        "-mcpu=${processor[$1]}" -mfpu=auto -mfloat-abi=hard "${@:2}"
}

firmware_in_c() { # arm board where-arm.h-is folder the-arm: links it and compares its bits
    gcc_for "$2" -O2 -nostdlib -I "$3" -I "$seen/c/$1/$2" c_caller/main.c c_caller/board.c "${@:5}" \
        -lgcc -T c_caller/link.ld -L "$memory" -Wl,-z,noexecstack -o "$4/firmware"
    emulate "$2" "$4/firmware" "$4/log"
    if ! diff "$seen/c/$1/$2/expected" "$4/log" >&2; then
        say "run.sh: called from C on $2, functions of $1 give other results than on the host"
        return 1
    fi
}

# --- the peer -------------------------------------------------------------------------------------

generate_peer() { # the peer's C of every arm, in $seen/peer/ARM/HOW
    local arm
    peer_tools "$CARGO_TARGET_DIR/peer"
    for arm in "${arms[@]}"; do
        mkdir -p "$seen/peer/$arm"
        peer_model "${urdf[$arm]}" "${tip[$arm]}" "$seen/peer/$arm/model"
        peer_generate "$seen/peer/$arm/model" float "$seen/peer/$arm"
    done
}

measure_peer() { # arm board how
    local from="$seen/peer/$1/$3" to="$seen/peer/$1/$2/$3" sines file flags
    flags=(-O2 -mthumb "-mcpu=${processor[$2]}" -mfpu=auto -mfloat-abi=hard)
    for sines in newlib none; do
        mkdir -p "$to/$sines"
        rm -f "$to/$sines"/*.o
        for file in "$from"/*.c; do
            arm-none-eabi-gcc "${flags[@]}" -w -fsingle-precision-constant -ffunction-sections \
                -fdata-sections -c "$file" -o "$to/$sines/$(basename "$file" .c).o"
        done
        if [ "$sines" = none ]; then
            echo 'float sinf(float a) { return a; } float cosf(float a) { return a; }' |
                arm-none-eabi-gcc "${flags[@]}" -x c -c - -o "$to/$sines/sines.o"
        fi
        # Linked with its sines here, because Rust has others of the same name, in double precision.
        arm-none-eabi-gcc "${flags[@]}" -nostdlib -r "$to/$sines"/*.o -lm -lc -o "$to/$sines/peer"
        PEER="$to/$sines/peer" build "$1" "$2" --features peer
        observe peer "$2" "$to/$sines"
    done
}

beside() { # writes the table beside the peer to $seen/peer.md
    local arm board how
    generate_peer
    {
        echo "With $("${rustc[@]}" --version | cut -d' ' -f1,2), GCC $(arm-none-eabi-gcc -dumpversion)" \
            "at \`-O2\`, and Pinocchio and CasADi as in [\`requirements.txt\`](../../report/peer/requirements.txt)," \
            "M4F / M7:"
        echo
        echo '| arm | function | code | instructions a call | at worst | without sines | text in bytes | stack in bytes | worst error in u |'
        echo '| --- | --- | --- | --- | --- | --- | --- | --- | --- |'
        for arm in "${arms[@]}"; do
            for board in "${boards[@]}"; do
                say "=== $arm on $board"
                build "$arm" "$board"
                observe controller "$board" "$seen/$arm/$board"
                for how in plain restrict; do measure_peer "$arm" "$board" "$how"; done
            done
            host "$arm" peer "$arm" "$seen" "${boards[@]}"
        done
    } >"$seen/peer.md"
}

# --- modes ----------------------------------------------------------------------------------------

same() { # description, committed, made
    if [ "$mode" = --update ]; then
        cp "$3" "$2"
    elif ! diff -u "$2" "$3" >&2; then
        say "run.sh: $1 changed; if it should, run it with --update"
        return 1
    fi
}

check() { # writes the tables to $seen/{table,c99}.md, and the lowered budget to $seen/budget.txt
    mkdir -p "$seen"
    {
        echo "With $("${rustc[@]}" --version | cut -d' ' -f1,2) and GCC $(arm-none-eabi-gcc -dumpversion)," \
            "\`${optimised[M4F]}\` on the M4F and \`${optimised[M7]}\` on the M7, M4F / M7:"
        echo
        echo '| arm | function | instructions in Rust | in C | bytes of text in Rust | in C |'
        echo '| --- | --- | --- | --- | --- | --- |'
    } >"$seen/c99.md"
    say "=== the host's own tests"
    "${cargo[@]}" test --quiet --profile host --locked -p host >&2
    {
        grep '^#' budget.txt >"$seen/budget.txt"
        echo "With $("${rustc[@]}" --version | cut -d' ' -f1,2), M4F / M7:"
        echo
        echo '| arm | function | instructions a call | text in bytes | stack in bytes | worst error in u |'
        echo '| --- | --- | --- | --- | --- | --- |'
        local arm board folders
        for arm in "${arms[@]}"; do
            say "=== $arm: what the host computes"
            host "$arm" expected >"$seen/expected.rs"
            same "what the host computes of $arm" "expected/$arm.rs" "$seen/expected.rs"
            folders=()
            for board in "${boards[@]}"; do
                say "=== $arm on $board"
                build "$arm" "$board"
                observe controller "$board" "$seen/$arm/$board"
                observe sines "$board" "$seen/sines/$board"
                call_from_c "$arm" "$board"
                folders+=("$seen/$arm/$board")
            done
            host "$arm" judge "$arm" budget.txt "${folders[@]}"
            host "$arm" budget "$arm" budget.txt "${folders[@]}" >>"$seen/budget.txt"
            host "$arm" c99 "$arm" "$seen" "${boards[@]}" >>"$seen/c99.md"
        done
        echo
        echo '| sine and cosine | instructions a call | text in bytes | worst error in u of the value | of 1 |'
        echo '| --- | --- | --- | --- | --- |'
        host "$arm" sines "${boards[@]/#/$seen/sines/}"
    } >"$seen/table.md"
}

paste() { # name, file, text: the text with the file between the comments of that name
    sed -n "1,/<!-- $1 -->/p" "$3"
    cat "$2"
    sed -n "/<!-- end of $1 -->/,\$p" "$3"
}

current() { # succeeds if README and budget are those measured; checked only with the compiler that they name
    local readme="$seen/README.md"
    paste table "$seen/table.md" README.md >"$seen/half.md"
    paste c99 "$seen/c99.md" "$seen/half.md" >"$readme"
    if [ "$mode" = --update ] || { grep -qxF "$(head -n 1 "$seen/table.md")" README.md &&
        grep -qxF "$(head -n 1 "$seen/c99.md")" README.md; }; then
        same "the tables of README.md" README.md "$readme"
        same "the budget that is needed" budget.txt "$seen/budget.txt"
    else
        say "run.sh: README.md and budget.txt are of another compiler, and are not compared"
    fi
}

# Changes the generated file after the build script, and expects an error.
mutate() { # description, expression of sed, expected error
    local arm=panda_class board=M4F folder="$seen/mutation/M4F" file
    say "=== mutation: $1"
    file=$(build "$arm" "$board" --message-format=json | written_by controller)/arm.rs
    cp "$file" "$seen/arm.rs"
    sed -i "$2" "$file"
    if cmp -s "$file" "$seen/arm.rs"; then
        say "run.sh: the mutation changes nothing"
        return 1
    fi
    build "$arm" "$board" && { observe controller "$board" "$folder" 2>/dev/null || true; }
    cp "$seen/arm.rs" "$file"
    if host "$arm" judge "$arm" budget.txt "$folder" >"$seen/report" 2>&1; then
        say "run.sh: no check noticed it"
        return 1
    elif ! grep -m 3 "$3" "$seen/report" >&2; then
        cat "$seen/report" >&2
        say "run.sh: no check reported '$3'"
        return 1
    fi
}

case "$mode" in
check | --update)
    check
    current
    cat "$seen/table.md" "$seen/c99.md"
    ;;
--quick)
    arms=("${arms[0]}")
    boards=("${boards[0]}")
    check
    cat "$seen/table.md" "$seen/c99.md"
    ;;
--peer)
    beside
    cat "$seen/peer.md"
    paste peer "$seen/peer.md" README.md >"$seen/README.md"
    cp "$seen/README.md" README.md
    ;;
--mutations)
    mkdir -p "$seen"
    mutate 'a wrong literal' '0,/ 0\.316_f32/s// 0.317_f32/' "are not the host's"
    mutate 'double precision' '0,/= s_2 \* s_1;/s//= (0.1_f64 * f64::from(s_2)) as f32;/' \
        'double precision'
    mutate 'a path that panics' '0,/let \[q_1/s//assert!(q[0] < 4.0); &/' 'a path that panics'
    say "=== every mutation was seen"
    ;;
*)
    say "usage: run.sh [--quick | --update | --mutations | --peer]"
    exit 2
    ;;
esac
