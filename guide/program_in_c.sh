#!/usr/bin/env bash
# What the chapter on embedded code says of C, done by the letter.
# Needs cargo and a compiler of C; HOMOGEN says where the command line is, which is built where it does not.
set -euo pipefail
chapter=embedded.md mark="program in C"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. tests/homogen.sh
. guide/letter.sh

# As `cargo install` would have put it there.
mkdir bin
ln -s "$homogen" bin/homogen
PATH="$PWD/bin:$PATH"
files main.c
prints bash -euo pipefail commands
