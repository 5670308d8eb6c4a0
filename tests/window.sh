#!/usr/bin/env bash
# Opens the editor on screens of its own: plays, resizes and reopens it, leaves it idle, brings it a bank, drops
# files on it, copies and pastes, doubles its pixels, and takes its OpenGL away. Wants Debian's xvfb, libegl1,
# libgl1-mesa-dri, libx11-xcb1 and libxkbcommon-x11-0. The pictures are in target/tmp: window.png, list.png,
# fine-*.png, plain.png, veil*.png and sheet*.png.
set -euo pipefail
cd "$(dirname "$0")/.."
data=$(mktemp -d)
screens=()
trap 'kill "${screens[@]}"; rm -r "$data"' EXIT

# Sets DISPLAY to a new screen of a size and with or without (+, -) GLX.
screen() {
    exec 3< <(exec Xvfb -displayfd 1 -screen 0 "$1x24" "$2extension" GLX +render -noreset 2>/dev/null)
    screens+=($!)
    read -r -u 3 number
    export DISPLAY=":$number"
}

run() {
    XDG_DATA_HOME="$data" cargo test -p idiophone-tests --test window -- --ignored --test-threads=1 "$@"
}

screen 1100x800 +
run a_window_opens a_window_in_which a_bank_put a_window_takes a_window_copies a_window_gives
screen 2000x1360 +
run a_window_on_a_fine_screen
screen 1100x800 -
__EGL_VENDOR_LIBRARY_FILENAMES=none run without_opengl
