# SPDX-License-Identifier: Apache-2.0
"""A recording of two minutes beside all that other programs may do to it: what is lost, and whether it is said."""
import collections
import contextlib
import os
import pathlib
import shutil
import sqlite3
import subprocess
import tempfile
import threading
import time

import built_tests
import live
import screen
import studio

SECONDS = 120
LOCKED_FROM_S, LOCKED_S = 20, 60
PROCESSES = 4
DISK = "4M"


class Beside:
    """Threads that disturb until the recording ends; each keeps how its programs ended."""

    def __init__(self):
        self.codes = collections.defaultdict(collections.Counter)
        self.over = threading.Event()
        self.threads = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.over.set()
        for thread in self.threads:
            thread.join()

    def start(self, work, *arguments):
        thread = threading.Thread(target=work, args=arguments)
        thread.start()
        self.threads.append(thread)

    def again_and_again(self, name, pause_s, *words):
        while not self.over.wait(pause_s):
            done = subprocess.run([studio.BUILD / "noctule", "--batch", *map(str, words)], capture_output=True)
            if self.over.is_set():
                return  # it may have begun when the recording was complete
            self.codes[name][done.returncode] += 1

    def hold_lock(self, take):
        if self.over.wait(LOCKED_FROM_S):
            return
        with contextlib.closing(sqlite3.connect(take, timeout=10, isolation_level=None)) as database:
            database.execute("BEGIN IMMEDIATE")
            self.over.wait(LOCKED_S)
            database.execute("ROLLBACK")
            self.codes[f"lock of {LOCKED_S} s"][0] += 1


@contextlib.contextmanager
def small_disk(folder):
    """A full disk's mount point, or None where none can be mounted."""
    folder.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={DISK}", "none", folder], capture_output=True).returncode:
        yield None
        return
    try:
        yield folder
    finally:
        subprocess.run(["umount", "-l", folder], check=True)


def gaps_and_holes(take):
    """Samples in gaps of all boards by the gaps' reason, and samples that are in no block and in no gap."""
    with studio.open_take(take) as database:
        gaps = database.execute("SELECT first_sample, sample_count FROM gap WHERE board IS NULL").fetchall()
        reasons = dict(database.execute("SELECT reason, sum(sample_count) FROM gap WHERE board IS NULL GROUP BY reason"))
        spans = gaps + database.execute("SELECT first_sample, sample_count FROM adc_block").fetchall()
    reached = holes = 0
    for first, count in sorted(spans):
        holes += max(0, first - reached)
        reached = max(reached, first + count)
    return reasons, holes


def disturb(beside, folder, disk, bystander):
    """All of it; the take that is being recorded is found by its name."""
    recorded = live.FOLDER / "live_001.noctule"
    deadline = time.monotonic() + 60
    while not recorded.exists() and time.monotonic() < deadline:
        time.sleep(0.1)
    for i in range(PROCESSES):
        copy = folder / f"bystander_{i}.noctule"
        shutil.copy(bystander, copy)
        beside.start(beside.again_and_again, "process of other takes", 0, "process", copy, "--root", "given")
    beside.start(beside.again_and_again, "process of this take", 5, "process", recorded)
    beside.start(beside.again_and_again, "inspect of this take", 1, "inspect", recorded)
    beside.start(beside.hold_lock, recorded)
    if disk:
        beside.start(beside.again_and_again, "process onto a full disk", 1, "process", bystander, "--out-dir", disk,
                     "--overwrite", "--root", "given")


def figure(_):
    with screen.own_screen() as display, screen.own_home(display) as environment:
        still = built_tests.run("test_ui_main_window", "RecordFlow.AScreenThatStandsStillLosesNothing", "OK",
                                environment)
    take, calibration = live.worn_take(SECONDS + 10)
    bystander = live.FOLDER / "bystander.noctule"
    studio.simulate(studio.REAL_MOTIONS / "01_01.bvh", bystander, "--duration", "10")
    for old in live.FOLDER.glob("live_*.noctule"):
        old.unlink()
    with tempfile.TemporaryDirectory(dir=live.FOLDER) as name, small_disk(pathlib.Path(name) / "disk") as disk, \
            Beside() as beside:
        starter = threading.Thread(target=disturb, args=(beside, pathlib.Path(name), disk, bystander))
        starter.start()
        try:
            report, _ = live.recorded(take, calibration, SECONDS)
        finally:
            starter.join()
            beside.over.set()
    path = live.FOLDER / os.path.basename(report["take"])
    reasons, holes = gaps_and_holes(path)
    in_gaps, said = sum(reasons.values()), " ".join(report["warnings"]).replace(f"{live.FOLDER}/", "")
    path.unlink()
    missed = []
    if report["lost_samples"] != in_gaps or holes:
        missed.append(f"said: {report['lost_samples']} samples lost; {in_gaps} stand in gaps, {holes} nowhere")
    if not any("another program held the take" in warning for warning in report["warnings"]):
        missed.append("the lock is not said")
    expected = {"process of other takes": {0}, "process of this take": {4}, "inspect of this take": {0},
                "process onto a full disk": {6}}
    for what, codes in expected.items():
        if set(beside.codes[what]) - codes:
            missed.append(f"{what} ended with {dict(beside.codes[what])}")
    rows = [[what, ", ".join(f"{count} times code {code}" for code, count in codes.items())]
            for what, codes in beside.codes.items()]
    text = (f"{SECONDS} s of 18 boards at 150 kHz, recorded and made into poses, beside {PROCESSES} programs that process other "
            f"takes, and a lock on the take from {LOCKED_FROM_S} s on for {LOCKED_S} s"
            f"{'' if disk else ' (no full disk: none can be mounted here)'}. Lost: {report['lost_samples']} samples, all of them in "
            f"gaps of the take: {reasons or 0}; in neither: {holes}. Said: {said}\n\n" +
            studio.markdown_table(["beside", "ended with"], rows) +
            f"\nThe studio's screen thread stands still for three seconds of a recording, nothing is lost:\n\n{still}\n")
    if missed:
        raise studio.Missed(missed, text)
    return text
