# A virtual environment for packages that `homogen python` writes, for scripts that run in the folder of the repository.
#
# In: its name, in `name`. Out: `folder`, which is empty but for it, `python`, and `pip`,
# which says little.
# shellcheck shell=bash disable=SC2034,SC2154

. tests/homogen.sh
folder="$built/$name"
rm -rf "$folder"
mkdir -p "$folder"
python3 -m venv "$folder/venv"
python="$folder/venv/bin/python"
pip() { "$folder/venv/bin/pip" --quiet --disable-pip-version-check "$@"; }
