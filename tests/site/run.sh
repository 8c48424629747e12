#!/usr/bin/env bash
# Tests the page of `homogen site` in Chromium: each robot of the repository, dropped as a file, has the values of
# `homogen eval`, bit for bit, and the files of `homogen generate`; hostile files end in a message. States the size of the
# module and times.
#
# Needs node (18 or later); installs Chromium if it is missing and the system has it as a package, and what
# `site/build.sh` needs. Pages and pictures stay in `site` in the build folder (target, or CARGO_TARGET_DIR).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

browser() { command -v chromium || command -v chromium-browser || command -v google-chrome; }

if ! browser >/dev/null; then
    as_root=()
    [ "$(id -u)" = 0 ] || as_root=(sudo)
    "${as_root[@]}" apt-get install -y --no-install-recommends chromium fonts-dejavu-core >/dev/null
fi

. tests/homogen.sh
output="$built/site-in-a-browser"
mkdir -p "$output"
"$homogen" site -o "$output/served"
node tests/site/check.mjs "$homogen" "$(browser)" "$output"
