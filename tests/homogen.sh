# The command line, for scripts that run in the folder of the repository.
#
# In: HOMOGEN, where it is there already. Out: `built`, the folder of all that is built, and `homogen`, the path of the
# program.
# shellcheck shell=bash disable=SC2034,SC2154

built="${CARGO_TARGET_DIR:-$PWD/target}"
homogen="${HOMOGEN:-}"
if [ -z "$homogen" ]; then
    cargo build --quiet --locked -p homogen-cli --bin homogen
    homogen="$built/debug/homogen"
elif [ ! -x "$homogen" ]; then
    echo "HOMOGEN is $homogen, which cannot be run" >&2
    exit 1
fi
