#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the examples of resources/docs/examples on a small take and compares what they print with its rows. Ends with 77, and with
the reason last, when an interpreter or a package of it is missing: CTest calls the test skipped then."""
import json
import pathlib
import shutil
import sqlite3
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXAMPLES = ROOT / "resources/docs/examples"
TINY = ROOT / "tests/data/takes/tiny_take.noctule"
JOINT = "LeftForeArm"
SKIPPED = 77  # tests/CMakeLists.txt names it to CTest


def take_with_poses(path):
    """The small take; what its simulation says of the truth becomes result 1."""
    shutil.copy(TINY, path)
    take = sqlite3.connect(path)
    take.executescript("""
        CREATE TABLE derived (run INTEGER PRIMARY KEY, kind TEXT, name TEXT);
        CREATE TABLE pose (run INTEGER, suit INTEGER, time_ns INTEGER, px REAL, py REAL, pz REAL, q BLOB);
        INSERT INTO derived VALUES (1, 'pose', 'test');
        INSERT INTO pose SELECT 1, 1, time_ns, px, py, pz, q FROM reference;
        INSERT INTO pose SELECT 1, 2, time_ns, px + 9, py, pz, q FROM reference;""")
    take.commit()
    return take


def expected_rows(take):
    joints = [joint["name"] for joint in json.loads(take.execute("SELECT json FROM actor").fetchone()[0])["joints"]]
    at = 4 * joints.index(JOINT)
    return [(time_ns / 1e9, x, y, z, *struct.unpack(f"<{4 * len(joints)}d", q)[at:at + 4]) for time_ns, x, y, z, q
            in take.execute("SELECT time_ns, px, py, pz, q FROM pose WHERE suit = 1 ORDER BY time_ns")]


def printed_rows(command):
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    if ran.returncode:
        sys.exit(f"{command[0]} ended with {ran.returncode}:\n{ran.stderr}")
    return [tuple(map(float, line.split())) for line in ran.stdout.splitlines()]


def compare(name, rows, expected):
    if len(rows) != len(expected) or not rows:
        sys.exit(f"{name}: {len(rows)} rows instead of {len(expected)}")
    for row, truth in zip(rows, expected):
        if len(row) != len(truth) or any(abs(a - b) > 6e-5 for a, b in zip(row, truth)):
            sys.exit(f"{name}: {row} instead of {truth}")
    print(f"{name}: {len(rows)} rows are right")


def has_r_packages(program):
    return subprocess.run([program, "-e", "library(RSQLite); library(jsonlite)"], capture_output=True,
                          check=False).returncode == 0


def main():
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "take.noctule"
        take = take_with_poses(path)
        expected = expected_rows(take)
        compare("Python", printed_rows([sys.executable, EXAMPLES / "read_take.py", path, JOINT]), expected)
        missing = []
        if not (program := shutil.which("Rscript")):
            missing.append("R: Rscript is not installed")
        elif not has_r_packages(program):
            missing.append("R: its packages RSQLite and jsonlite are not installed")
        else:
            compare("R", printed_rows([program, EXAMPLES / "read_take.R", path, JOINT]), expected)
        if not (program := shutil.which("octave-cli") or shutil.which("octave")):
            missing.append("Octave: it is not installed")
        else:
            table = pathlib.Path(folder) / "positions.csv"
            lines = [f"{row[0]:.6f},0,0,0," + ",".join(f"{value:.6f}" for value in row[1:4]) for row in expected]
            table.write_text("\n".join([f"time_s,Hips.x,Hips.y,Hips.z,{JOINT}.x,{JOINT}.y,{JOINT}.z", *lines]) + "\n")
            for arguments in (f"'{table}', '{JOINT}'", f"'{table}'"):
                compare("Octave", printed_rows([program, "--eval", f"""addpath('{EXAMPLES}');
                    [time_s, position_m] = read_positions({arguments});
                    fprintf('%.4f %.4f %.4f %.4f\\n', [time_s position_m]');"""]), [row[:4] for row in expected])
    if missing:
        print(f"examples.py: Skipped\nexamples in part: {'; '.join(missing)} (packaging/dependencies.sh examples)")
        sys.exit(SKIPPED)


if __name__ == "__main__":
    main()
