"""Builds the program that lets the engine ring, plugin/examples/ring."""

import json
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def build(release):
    """Path of the program."""
    # Without the window, which would have to be compiled too.
    command = ["cargo", "build", "--package", "idiophone", "--no-default-features"]
    command += ["--example", "ring"]
    command += ["--message-format", "json-render-diagnostics"]
    if release:
        command.append("--release")
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit("the engine does not build")
    for line in done.stdout.splitlines():
        message = json.loads(line)
        if message.get("executable") and message["target"]["name"] == "ring":
            return message["executable"]
    sys.exit("cargo names no program ring")
