#!/usr/bin/env python3
"""Instructions per mode and sample of the ringing engine, which load does not move.

    python3 bench/instructions.py [--most 1.2] [--dev]

Runs plugin/examples/ring under callgrind (apt install valgrind) for two lengths; what the longer
run takes more is the ringing alone. Valgrind shows a program AVX2 and no wider vectors, and the
engine takes what there is; a machine without AVX2 is not judged. Fails above --most.
"""

import argparse
import re
import shutil
import subprocess
import sys

import ring
from banks import machine

BODIES, MODES = 72, 72 * 64
SAMPLES = (3200, 6400)


def count(program, samples):
    """A callgrind run, started."""
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]
    command += [program, "render", str(BODIES), str(samples)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def collected(run):
    text, _ = run.communicate()
    found = re.search(r"Collected : (\d+)", text)
    if run.returncode or not found:
        sys.exit(f"callgrind failed:\n{text}")
    return int(found.group(1))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--most", type=float, default=1.2, help="fail above so many")
    parser.add_argument("--dev", action="store_true", help="built as the tests are")
    arguments = parser.parse_args()
    if not machine.has_avx2():
        print("no AVX2 here: not counted")
        return
    if not shutil.which("valgrind"):
        sys.exit("valgrind is not installed: apt install valgrind")
    program = ring.build(release=not arguments.dev)
    short, long = map(collected, [count(program, samples) for samples in SAMPLES])
    each = (long - short) / (MODES * (SAMPLES[1] - SAMPLES[0]))
    print(f"{each:.3f} instructions per mode and sample, {arguments.most} allowed")
    if each > arguments.most:
        sys.exit(1)


if __name__ == "__main__":
    main()
