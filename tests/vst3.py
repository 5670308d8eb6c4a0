"""The bundled VST3 in a host: loads, sounds, automates, keeps its state.

Usage: python tests/vst3.py target/bundled/Idiophone.vst3
Needs dawdreamer 0.9.0 and numpy.
"""

import sys
import tempfile
import time
from pathlib import Path

import dawdreamer
import numpy as np

RATE_HZ = 48_000
BLOCK = 512
# Parameters by the names and with the units that a host shows, by the ends of their text.
SHOWN = {
    "Strike position": "%",
    "Mallet hardness": "Pa",
    "Alpha 1": "s",
    "Alpha 2": "1/s",
    "Output gain": "dB",
}

failures = []


def check(what, ok, measured):
    print(f"{'ok  ' if ok else 'FAIL'}  {what}: {measured}")
    if not ok:
        failures.append(what)


def db(ratio):
    return 20 * np.log10(max(ratio, 1e-15))


def load(path):
    engine = dawdreamer.RenderEngine(RATE_HZ, BLOCK)
    plugin = engine.make_plugin_processor("idiophone", str(path))
    engine.load_graph([(plugin, [])])
    return engine, plugin


def strike(engine, plugin, key=74, velocity=100, seconds=2.0):
    plugin.clear_midi()
    plugin.add_midi_note(key, velocity, 0.1, 1.0)
    engine.render(seconds)
    return engine.get_audio()


def level(audio, start_s, end_s):
    return float(np.sqrt(np.mean(audio[:, int(start_s * RATE_HZ) : int(end_s * RATE_HZ)] ** 2)))


def descriptions(plugin):
    return {d["name"]: d for d in plugin.get_parameters_description()}


def index(plugin, name):
    return next(d["index"] for n, d in descriptions(plugin).items() if n.startswith(name))


def loudest_hz(audio):
    part = audio[0, int(0.2 * RATE_HZ) :]
    spectrum = np.abs(np.fft.rfft(part * np.hanning(len(part))))
    return float(np.argmax(spectrum) * RATE_HZ / len(part))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    path = Path(sys.argv[1]).resolve()
    if not path.is_dir():
        sys.exit(f"{path}: no VST3 bundle; `cargo xtask bundle` makes one")

    start = time.monotonic()
    engine, plugin = load(path)
    check("loads", True, f"{time.monotonic() - start:.2f} s")

    shown = descriptions(plugin)
    for name, unit in SHOWN.items():
        found = next((n for n in shown if n.startswith(name)), None)
        text = "missing" if found is None else shown[found]["text"] + shown[found].get("label", "")
        check(f"parameter {name}", found is not None and text.rstrip().endswith(unit), text)

    audio = strike(engine, plugin)
    check("stereo", audio.shape[0] == 2, audio.shape)
    check("finite", bool(np.isfinite(audio).all()), f"peak {db(np.abs(audio).max()):.1f} dBFS")
    check("silent before the note", level(audio, 0, 0.09) == 0, level(audio, 0, 0.09))
    check("sounds", level(audio, 0.1, 0.5) > 1e-3, f"{db(level(audio, 0.1, 0.5)):.1f} dBFS")
    # A hand on it since the key came up would have left less than -150 dBFS.
    check("rings on", level(audio, 1.5, 2.0) > 1e-5, f"{db(level(audio, 1.5, 2.0)):.1f} dBFS")
    hz = loudest_hz(audio)
    check("has a partial where it is loudest", 200 < hz < 20_000, f"{hz:.1f} Hz")

    # Alpha 1 steps up at one second: what rings dies at once much faster.
    engine, plugin = load(path)
    alpha1 = index(plugin, "Alpha 1")
    automation = np.full(2 * RATE_HZ, plugin.get_parameter(alpha1))
    kept = strike(engine, plugin)
    automation[RATE_HZ:] = 0.9
    engine, plugin = load(path)
    plugin.set_automation(alpha1, automation)
    damped = strike(engine, plugin)
    same = db(level(damped, 0.1, 0.9) / level(kept, 0.1, 0.9))
    less = db(level(damped, 1.5, 2.0) / level(kept, 1.5, 2.0))
    check("before automation nothing changes", abs(same) < 0.1, f"{same:.3f} dB")
    check("automating Alpha 1 damps what rings", less < -20, f"{less:.1f} dB")

    # A state goes through a file into another instance.
    engine, plugin = load(path)
    gain = index(plugin, "Output gain")
    plugin.set_parameter(alpha1, 0.7)
    plugin.set_parameter(gain, 0.4)
    strike(engine, plugin, seconds=0.5)
    wanted = [plugin.get_parameter(i) for i in (alpha1, gain)]
    with tempfile.TemporaryDirectory() as folder:
        state = str(Path(folder) / "state")
        plugin.save_state(state)
        engine, other = load(path)
        fresh = [other.get_parameter(i) for i in (alpha1, gain)]
        try:
            other.load_state(state)
        except RuntimeError as error:
            # dawdreamer 0.9.0 loads the state, then wants an editor to show it in.
            if "editor" not in str(error):
                raise
        strike(engine, other, seconds=0.5)
        held = [other.get_parameter(i) for i in (alpha1, gain)]
    off = max(abs(a - b) for a, b in zip(wanted, held))
    moved = min(abs(a - b) for a, b in zip(wanted, fresh))
    check("a state comes back", off < 1e-5 < moved, f"{off:.1e} off, {moved:.2f} from a fresh one")

    if failures:
        sys.exit(f"{len(failures)} failed: {', '.join(failures)}")


main()
