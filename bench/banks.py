#!/usr/bin/env python3
"""Our engine beside other banks of modes: how many ring at once on one core, at 48 kHz.

    python3 bench/banks.py [--modes 4608] [--rounds 20] [--ops 4.1] [--dev]

All ring with T60 60 s, in blocks of 64, denormals flushed. Each bank is built, then all are run in
turn, round after round, and the best of all rounds counts: load and a moving clock hit all alike.
For x86-64 with AVX2 on Linux. A bank that is not installed is named and left out:

  phasors         apt install gcc
  Faust           apt install faust g++
  SuperCollider   apt install supercollider-server supercollider-language

Phasors and Faust are built for each width of vectors with several settings, and the best counts;
SuperCollider is Debian's build, timed by user and system time as a difference of two lengths.
FMA slots are ops x modes x rate / (lanes x FMAs a second), --ops for each of our modes and samples.
"""

import argparse
import os
import sys
import tempfile

from banks import build, figures, machine


def measure(banks, rounds):
    for number in range(rounds):
        print(f"\rround {number + 1} of {rounds}", end="", file=sys.stderr)
        for bank in banks:
            for runs in bank.by_width.values():
                for run in runs:
                    run.again()
    print(file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--modes", type=int, default=4608, help="a multiple of 192, up to 8064")
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--ops", type=float, default=4.1, help="of ours, for a mode and sample")
    parser.add_argument("--dev", action="store_true", help="ours built as the tests are")
    arguments = parser.parse_args()
    if arguments.modes % 192 or not 0 < arguments.modes <= 8064:
        parser.error(f"--modes {arguments.modes}: must be a multiple of 192, up to 8064")
    if arguments.rounds < 1:
        parser.error(f"--rounds {arguments.rounds}: must be at least 1")
    widths = machine.widths()
    with tempfile.TemporaryDirectory() as folder:
        units = build.units(folder, widths)
        ours = build.ours(arguments.modes, widths, not arguments.dev)
        peers = build.peers(folder, arguments.modes, widths)
        before = os.getloadavg()[0]
        measure([units, ours, *peers], arguments.rounds)
        loads = before, os.getloadavg()[0]
    print(machine.description(arguments.rounds, loads))
    print()
    print(figures.beside(ours, peers, widths))
    print()
    print(figures.own(ours, units, widths, arguments.ops))


if __name__ == "__main__":
    main()
