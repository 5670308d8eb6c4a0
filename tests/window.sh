#!/usr/bin/env bash
# Opens the editor on a screen of its own, plays, resizes and reopens it, and brings it a bank. Wants Debian's
# xvfb, libegl1, libgl1-mesa-dri, libx11-xcb1 and libxkbcommon-x11-0. The pictures are target/tmp/window.png
# and list.png.
set -euo pipefail
cd "$(dirname "$0")/.."
exec 3< <(exec Xvfb -displayfd 1 -screen 0 1100x800x24 +extension GLX +render -noreset 2>/dev/null)
screen=$!
data=$(mktemp -d)
trap 'kill "$screen"; rm -r "$data"' EXIT
read -r -u 3 number
DISPLAY=":$number" XDG_DATA_HOME="$data" \
    cargo test -p idiophone-tests --test window -- --ignored --test-threads=1
