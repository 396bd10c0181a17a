# SPDX-License-Identifier: Apache-2.0
"""A whole suit in real time from the separate program over TCP, through decoding, filter and recorder: what is lost, how
late poses are, what it costs; and whether the same sound gives the same results from the file."""
import contextlib
import json
import os
import shutil
import signal
import sqlite3
import subprocess

import studio

MOST_MEDIAN_MS, MOST_P999_MS = 10, 25
MOST_LOAD = 0.7  # of one core
RESULTS = "inertial", "range", "pose"
FOLDER = studio.OUT / "live"


def worn_take(seconds):
    """Simulated once, it stays for the next time, with its calibration beside it."""
    take = FOLDER / f"worn_{seconds}.noctule"
    calibration = take.with_suffix(".json")
    if not calibration.exists():
        made = take.with_suffix(".calibration")
        studio.simulate(studio.REAL_MOTIONS / "01_01.bvh", take, "--duration", seconds, "--calibration-out", made)
        made.rename(calibration)
    return take, calibration


def recorded(take, calibration, seconds):
    """What `record --json` says, and the processor time it took."""
    suit = subprocess.Popen([studio.BUILD / "noctule-virtual-suit", "--take", take, "--tcp", "127.0.0.1:0"],
                            stdout=subprocess.PIPE, text=True)
    try:
        address = next(word for line in suit.stdout for word in line.split() if word.startswith("tcp://"))
        recorder = subprocess.Popen(
            [studio.BUILD / "noctule", "--batch", "record", "--device", address, "--out-dir", FOLDER, "--name", "live",
             "--seconds", str(seconds), "--rest-seconds", "3", "--calibration", calibration, "--keep-results", "--json"],
            stdout=subprocess.PIPE, text=True)
        said = recorder.stdout.read()
        _, status, usage = os.wait4(recorder.pid, 0)
        recorder.returncode = os.waitstatus_to_exitcode(status)
    finally:
        suit.send_signal(signal.SIGINT)
        suit.wait()
    if recorder.returncode != 0:
        raise RuntimeError(f"record: exit code {recorder.returncode}")
    return json.loads(said), usage.ru_utime + usage.ru_stime


def columns_of(database, table):
    return [row[1] for row in database.execute(f"PRAGMA table_info({table})") if row[1] != "run"]


def copy_without_results(take, bare):
    """The recorded tables only."""
    shutil.copy(take, bare)
    with contextlib.closing(sqlite3.connect(bare)) as database:
        for table in ("derived", *RESULTS):
            database.execute(f"DELETE FROM {table}")
        database.commit()


def differences(live_take, file_take):
    """How many rows of each result there are, and how many one take has and the other has not."""
    found = []
    with studio.open_take(live_take) as database:
        database.execute("ATTACH ? AS file", (str(file_take),))
        for table in RESULTS:
            columns = ", ".join(columns_of(database, table))
            rows = [f"SELECT {columns} FROM {schema}.{table}" for schema in ("main", "file")]
            apart = sum(database.execute(f"SELECT count(*) FROM ({a} EXCEPT {b})").fetchone()[0]
                        for a, b in (rows, rows[::-1]))
            counts = [database.execute(f"SELECT count(*) FROM ({one})").fetchone()[0] for one in rows]
            found.append([table, *counts, apart])
    return found


def figure(options):
    seconds = options.live_seconds
    take, calibration = worn_take(seconds + 10)
    report, busy_s = recorded(take, calibration, seconds)
    live, load = report["live"], busy_s / seconds
    path = FOLDER / os.path.basename(report["take"])
    bare = path.with_name(f"bare_{path.name}")
    try:
        copy_without_results(path, bare)
        studio.batch("process", bare, "--sensors", "AGD", "--root", "free")
        same = differences(path, bare)
    finally:
        path.unlink()
        bare.unlink(missing_ok=True)
    missed = []
    if report["lost_samples"] or live["dropped_samples"]:
        missed.append(f"{report['lost_samples']} samples are lost, {live['dropped_samples']} were not processed")
    if live["latency_median_ms"] > MOST_MEDIAN_MS or live["latency_p999_ms"] > MOST_P999_MS:
        missed.append(f"poses come {live['latency_median_ms']:.1f} ms late in the median, "
                      f"{live['latency_p999_ms']:.1f} ms at 99.9 %")
    if load > MOST_LOAD:
        missed.append(f"it takes {load:.2f} of a core")
    if any(not of_live or of_live != of_file or apart for _, of_live, of_file, apart in same):
        missed.append("results of live and file differ")
    text = (f"{seconds} s of 18 boards and 8 sources at 150 kHz from `noctule-virtual-suit` over TCP (01_01, pre-rendered), "
            "recorded and made into poses at once. Latency counts from the arrival of the block that holds a frame's last "
            f"bit; at most {MOST_MEDIAN_MS} ms in the median and {MOST_P999_MS} ms at 99.9 %.\n\n" +
            studio.markdown_table(
                ["samples lost", "poses", "median, ms", "99.9 %, ms", "worst, ms", "slowest commit, ms", "of one core"],
                [[report["lost_samples"], live["poses"], *(studio.number(value, 1) for value in (
                    live["latency_median_ms"], live["latency_p999_ms"], live["latency_worst_ms"],
                    report["slowest_commit_ms"])), f"{load:.0%}"]]) +
            "\nThe same take processed from its file:\n\n" +
            studio.markdown_table(["table", "rows, live", "rows, file", "rows that differ"], same))
    if missed:
        raise studio.Missed(missed, text)
    return text
