#!/usr/bin/env python3
"""Puts what commands print where a page names them.

    python3 bench/page.py docs/engine.md

Runs every command that the page has between `<!-- $` and `-->` at the start of a line, from the
root of the repository, and replaces the lines from there to `<!-- end -->` by its output.
"""

import os
import re
import shlex
import subprocess
import sys

from ring import ROOT

BLOCK = re.compile(r"^<!-- \$ (.+?) -->\n.*?^<!-- end -->$", re.MULTILINE | re.DOTALL)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    path = os.path.abspath(sys.argv[1])
    failed = []

    def filled(block):
        command = block.group(1)
        print(f"$ {command}", file=sys.stderr)
        words = shlex.split(command)
        done = subprocess.run(words, cwd=ROOT, stdout=subprocess.PIPE, text=True)
        if done.returncode:
            failed.append(command)
        return f"<!-- $ {command} -->\n{done.stdout.strip()}\n<!-- end -->"

    with open(path) as page:
        text = BLOCK.sub(filled, page.read())
    with open(path, "w") as page:
        page.write(text)
    if failed:
        sys.exit("failed: " + "; ".join(failed))


if __name__ == "__main__":
    main()
