"""What these figures were measured on."""

import os
import platform
import shutil
import subprocess
import sys
from collections import namedtuple

# Name in tables, name for our engine, floats in a vector, sets of flags of which the best counts.
Width = namedtuple("Width", "title name lanes flags")
AVX2 = Width("AVX2", "avx2", 8, (("-march=x86-64-v3",),))
AVX512 = Width(
    "AVX-512",
    "avx512",
    16,
    tuple(
        (march, *more)
        for march in ("-march=x86-64-v4", "-march=native")
        for more in ((), ("-mprefer-vector-width=512",))
    ),
)


def processor():
    """The fields of the first core in /proc/cpuinfo."""
    with open("/proc/cpuinfo") as file:
        lines = file.read().split("\n\n")[0].splitlines()
    return dict(map(str.strip, line.split(":", 1)) for line in lines if ":" in line)


def has(*features):
    return platform.machine() == "x86_64" and set(features) <= set(processor()["flags"].split())


def has_avx2():
    return has("avx2", "fma")


def widths():
    """The widths of vectors that this machine has."""
    if not has_avx2():
        sys.exit("banks are compared on x86-64 with AVX2 and FMA, which this machine has not")
    wide = has("avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl")
    return [AVX2, AVX512] if wide else [AVX2]


def compiler(variable, usual):
    """The compiler that the environment names, or the usual one, if it is there."""
    return shutil.which(os.environ.get(variable, usual))


def description(rounds, loads):
    """One line: processor, rounds, load, versions."""
    told = [
        processor().get("model name", "unknown processor"),
        f"best of {rounds} rounds",
        "load {:.1f} to {:.1f}".format(*loads),
    ]
    for tool, flag in (
        (compiler("CC", "gcc"), "--version"),
        (shutil.which("faust"), "--version"),
        (shutil.which("scsynth"), "-v"),
    ):
        if tool:
            done = subprocess.run([tool, flag], stdout=subprocess.PIPE, text=True)
            told.append(done.stdout.split("\n")[0].split(" (Built")[0].strip())
    return "; ".join(told) + "."
