"""One way to run one bank, again and again."""

import json
import os
import resource
import subprocess
import sys


class Program:
    """Prints a number, the greater the better."""

    def __init__(self, *command):
        self.command = list(map(str, command))
        self.best = 0.0

    def again(self):
        text = subprocess.run(self.command, stdout=subprocess.PIPE, text=True, check=True).stdout
        self.best = max(self.best, float(text))


class Ours:
    """Prints several figures as JSON; the best of each counts."""

    def __init__(self, *command):
        self.command = list(map(str, command))
        self.best = 0.0
        self.low = 0.0
        self.automated = 0.0
        self.keyboard = float("inf")

    def works(self):
        """Whether the engine can be held to what is asked; says why not."""
        done = subprocess.run(self.command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        if done.returncode:
            print(f"ours: {done.stderr.decode().strip()}", file=sys.stderr)
        return done.returncode == 0

    def again(self):
        done = subprocess.run(self.command, stdout=subprocess.PIPE, text=True, check=True)
        told = json.loads(done.stdout)
        self.best = max(self.best, told["steady_modes"])
        self.low = max(self.low, told["low_modes"])
        self.automated = max(self.automated, told["automated_modes"])
        self.keyboard = min(self.keyboard, told["keyboard_share"])


class Difference:
    """Two lengths of one thing: what the longer takes more is the ringing alone."""

    def __init__(self, modes, command, lengths_s, surroundings):
        self.modes = modes
        self.commands = [command(length) for length in lengths_s]
        self.lengths_s = lengths_s
        self.surroundings = surroundings
        self.least = [float("inf")] * 2

    def again(self):
        for i, command in enumerate(self.commands):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run(
                command, env=self.surroundings, stdout=subprocess.DEVNULL, check=True
            )
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            self.least[i] = min(self.least[i], spent)

    @property
    def best(self):
        longer_s = self.lengths_s[1] - self.lengths_s[0]
        return self.modes * longer_s / (self.least[1] - self.least[0])


def surroundings(folder):
    """Of a program that must find no screen, leave no files at home and may run as root."""
    return {
        **os.environ,
        "HOME": folder,
        "XDG_RUNTIME_DIR": folder,
        "QT_QPA_PLATFORM": "offscreen",
        "QTWEBENGINE_DISABLE_SANDBOX": "1",
    }
