#!/usr/bin/env bash
# Draws the README's pictures anew: the window with each instrument, at two pixels to a point, in docs/pictures.
set -euo pipefail
cd "$(dirname "$0")/.."
cargo test -p idiophone --features gui --test editor every_instrument_is_pictured -- --ignored
ls -l docs/pictures
