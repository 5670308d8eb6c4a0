"""Builds the banks and says what is missing."""

import os
import shutil
import subprocess
import sys
from collections import namedtuple

import ring
from banks import machine, run

HERE = os.path.dirname(os.path.abspath(__file__))
FAST = ["-O3", "-ffast-math"]
RUNS = 100

# Modes of one copy, as bank.dsp has them and as a Klank holds well.
FAUST_MODES = 8
KLANK_MODES = 192
KLANK_S = (1, 4)

# A bank's ways to run, of which the best counts, by width of vectors.
Bank = namedtuple("Bank", "title channels precision by_width")


def missing(title, packages):
    print(f"{title}: left out; apt install {packages}", file=sys.stderr)


def compile_all(compiler, source, program, flags):
    """Paths of one program, compiled with each of several sets of flags."""
    for number, more in enumerate(flags):
        path = f"{program}-{number}"
        command = [compiler, *FAST, *more, "-I", HERE, source, "-o", path, "-lm"]
        subprocess.run(command, check=True)
        yield path


def units(folder, widths):
    """The machine's own rate of FMAs."""
    by_width = {}
    compiler = machine.compiler("CC", "gcc")
    for width in widths if compiler else []:
        flags = [*width.flags[0], f"-DBYTES={4 * width.lanes}", "-mprefer-vector-width=512"]
        path = f"{folder}/fma-{width.name}"
        programs = compile_all(compiler, f"{HERE}/fma.c", path, [flags])
        by_width[width] = [run.Program(program, RUNS) for program in programs]
    return Bank("FMA", None, None, by_width)


def ours(modes, widths, release):
    program = ring.build(release)
    by_width = {}
    for width in widths:
        asked = run.Ours(program, "time", modes // 64, 1, width.name)
        if asked.works():
            by_width[width] = [run.Ours(program, "time", modes // 64, RUNS, width.name)]
    return Bank("Idiophone", "stereo", "f32 in cells, f64 across", by_width)


def peers(folder, modes, widths):
    """The others that are installed and can be built."""
    built = []
    for make in (phasors, faust, klank):
        try:
            bank = make(folder, modes, widths)
        except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as error:
            print(f"{make.__name__}: left out; {error}", file=sys.stderr)
            continue
        if bank:
            built.append(bank)
    return built


def phasors(folder, modes, widths):
    title = "Plain loop in C"
    compiler = machine.compiler("CC", "gcc")
    if not compiler:
        return missing(title, "gcc")
    by_width = {}
    for width in widths:
        path = f"{folder}/phasors-{width.name}"
        programs = compile_all(compiler, f"{HERE}/phasors.c", path, width.flags)
        by_width[width] = [run.Program(program, modes, RUNS) for program in programs]
    return Bank(title, "stereo", "f32", by_width)


def faust(folder, modes, widths):
    title = "Faust `pm.modeFilter`"
    compiler = machine.compiler("CXX", "g++")
    if not compiler or not shutil.which("faust"):
        return missing(title, "faust g++")
    by_width = {width: [] for width in widths}
    for loop in "01":
        for samples in ("32", "64"):
            source = f"{folder}/faust-{loop}-{samples}"
            command = ["faust", "-a", f"{HERE}/faust.cpp", "-vec", "-lv", loop, "-vs", samples]
            command += [f"{HERE}/bank.dsp", "-o", f"{source}.cpp"]
            subprocess.run(command, check=True)
            for width in widths:
                flags = [(*more, f"-DMODES={FAUST_MODES}") for more in width.flags]
                path = f"{source}-{width.name}"
                for program in compile_all(compiler, f"{source}.cpp", path, flags):
                    by_width[width].append(run.Program(program, modes // FAUST_MODES, RUNS))
    return Bank(title, "stereo", "f32", by_width)


def klank(folder, modes, widths):
    title = "SuperCollider `Klank`"
    if not shutil.which("scsynth") or not shutil.which("sclang"):
        return missing(title, "supercollider-server supercollider-language")
    surroundings = run.surroundings(folder)
    lengths = [str(length) for length in KLANK_S]
    command = ["sclang", f"{HERE}/klank.scd", str(modes // KLANK_MODES), str(KLANK_MODES)]
    command += [folder, *lengths]
    subprocess.run(command, env=surroundings, stdout=subprocess.DEVNULL, check=True, timeout=120)

    def play(length):
        score = ["scsynth", "-N", f"{folder}/{length}.osc", "_", f"{folder}/klank.wav"]
        return score + "48000 WAV float -o 1 -i 0 -z 64 -m 65536".split()

    once = run.Difference(modes, play, KLANK_S, surroundings)
    # Debian's build has one width for all machines: one measurement stands in every column.
    return Bank(title, "mono", "f32", {width: [once] for width in widths})
