#!/usr/bin/env bash
# Tests pages of `homogen show` in Chromium: no errors in the console, correct poses, an explanation of each name, no
# horizontal scrolling on a phone, names of a hostile file stay text.
#
# Needs node (18 or later); installs Chromium if it is missing and the system has it as a package. Pages and pictures
# stay in `show` in the build folder (target, or CARGO_TARGET_DIR).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."


browser() { command -v chromium || command -v chromium-browser || command -v google-chrome; }

if ! browser >/dev/null; then
    as_root=()
    [ "$(id -u)" = 0 ] || as_root=(sudo)
    "${as_root[@]}" apt-get install -y --no-install-recommends chromium fonts-dejavu-core >/dev/null
fi

. tests/homogen.sh
mkdir -p "$built/show"
node tests/show/check.mjs "$homogen" "$(browser)" "$built/show"
