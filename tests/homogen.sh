# Builds the command line, for scripts that run in the folder of the repository.
#
# In: HOMOGEN, the path of an existing program, if any. Out: `built`, the build folder, and `homogen`, the path of the
# program.
# shellcheck shell=bash disable=SC2034,SC2154

built="${CARGO_TARGET_DIR:-$PWD/target}"
homogen="${HOMOGEN:-}"
if [ -z "$homogen" ]; then
    cargo build --quiet --locked -p homogen-cli --bin homogen
    homogen="$built/debug/homogen"
elif [ ! -x "$homogen" ]; then
    echo "HOMOGEN is $homogen, which is not executable" >&2
    exit 1
fi
