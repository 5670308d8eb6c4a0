#!/usr/bin/env bash
# Runs the program of its own on a screen of its own, without sound. Wants Debian's pkg-config, libasound2-dev,
# libjack-jackd2-dev, xvfb, x11-utils, libegl1, libgl1-mesa-dri, libx11-xcb1 and libxkbcommon-x11-0.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(cargo metadata --format-version=1 --no-deps | sed -E 's/.*"target_directory":"([^"]*)".*/\1/')
cargo build -p idiophone --features standalone
exec 3< <(exec Xvfb -displayfd 1 -screen 0 1100x800x24 +extension GLX +render -noreset 2>/dev/null)
screen=$!
read -r -u 3 number
export DISPLAY=":$number"
"$target/debug/idiophone" --backend dummy &
program=$!
trap 'kill "$program" "$screen" 2>/dev/null || true' EXIT
for _ in {1..20}; do
    sleep 0.5
    kill -0 "$program"
    if xwininfo -root -tree | grep -q '"Idiophone"'; then
        sleep 2
        kill -0 "$program"
        echo "The window is open."
        exit 0
    fi
done
echo "There is no window after ten seconds." >&2
exit 1
