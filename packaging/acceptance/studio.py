# SPDX-License-Identifier: Apache-2.0
"""The built program, driven as any user would: by its command line and its take files."""
import contextlib
import json
import os
import pathlib
import sqlite3
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "release" / "bin"
OUT = ROOT / "out" / "acceptance"
REAL_MOTIONS = pathlib.Path("/usr/share/assimp/models/BVH")
MORE_MOTIONS = ROOT.parent / "shared" / "data" / "bvh" / "cmu"


class Missed(RuntimeError):
    """A figure that was measured but not reached; its text is kept all the same."""

    def __init__(self, reasons, text):
        super().__init__("; ".join(reasons))
        self.text = f"{text}\nNot reached: {self}.\n"


def batch(*arguments):
    """Standard output of `noctule --batch ARGUMENTS`; what goes wrong ends the figure with its message."""
    command = [str(BUILD / "noctule"), "--batch", *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def simulate(motion, take, *options):
    take.parent.mkdir(parents=True, exist_ok=True)
    batch("simulate", "--motion", motion, "--out", take, "--scenario", "nominal", "--seed", 1, *options,
          "--overwrite")


def process(take, sensors, run, *options):
    batch("process", take, "--sensors", sensors, "--root", "given", "--run-name", run, *options)


def evaluate(take, run, *options):
    return json.loads(batch("evaluate", take, "--run", run, *options, "--json"))


def open_take(take):
    """Its database, for reading, closed at the end of the with statement."""
    return contextlib.closing(sqlite3.connect(take.as_uri() + "?mode=ro", uri=True))


def take_seconds(take):
    with open_take(take) as database:
        meta = dict(database.execute("SELECT key, value FROM meta"))
    return int(meta["sample_count"]) / int(meta["sample_rate_hz"])


def seconds_on_one_core(work):
    """Wall time of work(), the programs it starts bound to one core."""
    allowed = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(allowed)})
    try:
        begin = time.monotonic()
        work()
        return time.monotonic() - begin
    finally:
        os.sched_setaffinity(0, allowed)


def number(value, digits=2):
    """What the program does not know is null."""
    return "unknown" if value is None else f"{value:.{digits}f}"


def markdown_table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"
