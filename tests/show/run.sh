#!/usr/bin/env bash
# Opens pages of `homogen show` in Chromium: no complaints, joints that move as they should, names that tell what
# they are, no scrolling sideways on a phone, names of a hostile file that stay text.
#
# Needs node (18 or later); installs Chromium where it is missing and the system has it as a package. Pages and
# pictures are left in target/show, or where CARGO_TARGET_DIR says.
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
