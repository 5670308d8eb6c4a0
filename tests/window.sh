#!/usr/bin/env bash
# Opens the editor on a screen of its own, plays, resizes and reopens it. Wants Debian's xvfb, libegl1,
# libgl1-mesa-dri, libx11-xcb1 and libxkbcommon-x11-0. The picture is target/tmp/window.png.
set -euo pipefail
cd "$(dirname "$0")/.."
exec 3< <(exec Xvfb -displayfd 1 -screen 0 1100x800x24 +extension GLX +render -noreset 2>/dev/null)
screen=$!
trap 'kill "$screen"' EXIT
read -r -u 3 number
DISPLAY=":$number" cargo test -p idiophone-tests --test window -- --ignored
