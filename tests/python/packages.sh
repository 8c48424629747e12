# Creates a virtual environment for packages of `homogen python`, for scripts that run in the folder of the repository.
#
# In: `name`, the name of the folder. Out: `folder`, which contains only the environment; `python`; and a quiet `pip`.
# shellcheck shell=bash disable=SC2034,SC2154

. tests/homogen.sh
folder="$built/$name"
rm -rf "$folder"
mkdir -p "$folder"
python3 -m venv "$folder/venv"
python="$folder/venv/bin/python"
pip() { "$folder/venv/bin/pip" --quiet --disable-pip-version-check "$@"; }
