# What a chapter of the guide says, done by the letter: its commands, its files, its output.
#
# In: `chapter`, the name of its file, and `mark`: blocks of code follow comments `<!-- MARK: NAME -->`. Out: `block`, which
# prints one of them, and an empty folder that is the working directory, with the repository beside it as `homogen`;
# `root` is where that is. What crates are built in is target/letter, or where CARGO_TARGET_DIR says.
# shellcheck shell=bash disable=SC2154

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$root/target/letter}"

block() { # name
    local text
    text=$(awk -v mark="<!-- $mark: $1 -->" '
        $0 == mark { found = 1; next }
        found && /^```/ { if (inside) exit; inside = 1; next }
        inside { print }
    ' "$root/guide/src/$chapter")
    [ -n "$text" ] || { echo "$chapter has no block $mark: $1" >&2; return 1; }
    printf '%s\n' "$text"
}

files() { # names: makes these files as the chapter has them
    local file
    for file in "$@"; do block "$file" >"$file"; done
}

prints() { # command: has to print what the chapter says
    "$@" >printed
    block output | diff - printed
    echo "$chapter: its ${mark} prints what it says"
}

letter=$(mktemp -d)
trap 'rm -r "$letter"' EXIT
cd "$letter"
ln -s "$root" homogen
block commands >commands
