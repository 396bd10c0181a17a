# SPDX-License-Identifier: Apache-2.0
"""Two whole suits in real time, each from a box of its own over TCP, into one take: what is lost, how late the poses of
each are, how well the recorder guessed the clock, and what processing makes of the take."""
import contextlib
import json
import os
import re
import signal
import sqlite3
import subprocess

import cast
import studio

MOST_MEDIAN_MS = 20
MOST_GUESS_MS = 5
PROCESSED_S = 60  # of the take; a longer one is recorded only
SUBJECTS = "A", "B"
FOLDER = studio.OUT / "cast_live"


def worn_tape(seconds):
    """The handshake as sound of two whole suits, again and again; simulated once, it stays for the next time."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    tape = FOLDER / f"handshake_{seconds}.noctule"
    if not tape.exists():
        path = cast.cast_of("handshake", FOLDER)
        wanted = {**json.loads(path.read_text()), "shared_clock": True}
        del wanted["room"]
        path.write_text(json.dumps(wanted))
        studio.batch("simulate", "--cast", path, "--level", "signal", "--scenario", "nominal", "--seed", 301,
                     "--duration", seconds, "--out", tape)
    return tape


def documents_of(tape, table):
    """A file per suit, in their order."""
    paths = []
    with studio.open_take(tape) as database:
        for suit, text in database.execute(f"SELECT suit, json FROM {table} ORDER BY suit"):
            paths.append(FOLDER / f"{table}_{suit}.json")
            paths[-1].write_text(text)
    return paths


@contextlib.contextmanager
def boxes(tape, started_s):
    """Their addresses. When each began to sample, on this machine's clock, is added at the end."""
    running = []
    try:
        for subject in SUBJECTS:
            running.append(subprocess.Popen(
                [studio.BUILD / "noctule-virtual-suit", "--take", tape, "--subject", subject, "--tcp", "127.0.0.1:0",
                 "--loop"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True))
        yield [next(word for line in box.stdout for word in line.split() if word.startswith("tcp://"))
               for box in running]
    finally:
        for box in running:
            box.send_signal(signal.SIGINT)
        for box in running:
            started_s += [float(found) for found in re.findall(r"started at ([\d.]+) s", box.communicate()[0])[-1:]]


def recorded(tape, seconds):
    """What `record --json` says, the processor time it took, and how far off the guess of the second clock is in ms."""
    started_s = []
    with boxes(tape, started_s) as addresses:
        each = [("--device", addresses), ("--calibration", documents_of(tape, "calibration")),
                ("--actor", documents_of(tape, "actor")), ("--subject", SUBJECTS)]
        options = [word for name, values in each for value in values for word in (name, str(value))]
        recorder = subprocess.Popen(
            [studio.BUILD / "noctule", "--batch", "record", *options, "--out-dir", FOLDER, "--name", "live", "--seconds",
             str(seconds), "--rest-seconds", "3", "--json"], stdout=subprocess.PIPE, text=True)
        said = recorder.stdout.read()
        _, status, usage = os.wait4(recorder.pid, 0)
        recorder.returncode = os.waitstatus_to_exitcode(status)
    if recorder.returncode != 0:
        raise RuntimeError(f"record: exit code {recorder.returncode}")
    report = json.loads(said)
    guess_ms = report["suits"][1]["clock_offset_ms"] - 1000 * (started_s[1] - started_s[0])
    return report, usage.ru_utime + usage.ru_stime, guess_ms


def found_in_take(tape, take):
    """With the truth of the simulation: mean angles, and the worst pair between both."""
    with contextlib.closing(sqlite3.connect(take)) as database:
        database.execute("ATTACH ? AS tape", (str(tape),))
        database.execute("CREATE TABLE reference AS SELECT * FROM tape.reference")
        database.execute("INSERT INTO meta SELECT * FROM tape.meta WHERE key LIKE 'reference_%'")
        database.commit()
    studio.batch("process", take, "--between", "on", "--run-name", "joined")
    found = studio.evaluate(take, "joined")
    hips = next(pair for pair in found["between"] if pair["from"] == "Hips")
    return [*(studio.number(subject["mean_deg"]) for subject in found["subjects"]), studio.number(hips["rms_mm"], 1),
            studio.number(max(pair["rms_mm"] for pair in found["between"]), 1), studio.number(hips["heading_deg"])]


def figure(options):
    seconds = options.cast_live_seconds
    tape = worn_tape(min(seconds, PROCESSED_S) + 10)
    report, busy_s, guess_ms = recorded(tape, seconds)
    take = FOLDER / os.path.basename(report["take"])
    rows, missed = [], []
    for suit in report["suits"]:
        live = suit["live"]
        rows.append([suit["subject"], suit["lost_samples"], live["dropped_samples"], live["poses"],
                     *(studio.number(value, 1) for value in (live["latency_median_ms"], live["latency_p999_ms"],
                                                             live["latency_worst_ms"], suit["slowest_commit_ms"]))])
        if suit["lost_samples"] or live["dropped_samples"] or suit["seconds"] < seconds:
            missed.append(f"of {suit['subject']} {suit['lost_samples']} samples are lost, {live['dropped_samples']} not "
                          "processed")
        if live["latency_median_ms"] > MOST_MEDIAN_MS:
            missed.append(f"poses of {suit['subject']} come {live['latency_median_ms']:.1f} ms late in the median")
    if abs(guess_ms) > MOST_GUESS_MS:
        missed.append(f"the clock's first guess is {guess_ms:.1f} ms off")
    text = (f"{seconds} s of the handshake, two suits of 18 boards and 8 sources at 150 kHz, from two "
            "`noctule-virtual-suit` over TCP (pre-rendered), recorded into one take and made into poses at once. Latency "
            f"as for one suit; at most {MOST_MEDIAN_MS} ms in the median. First guess of the second clock: "
            f"{guess_ms:.2f} ms off. It took {busy_s / seconds:.0%} of one core.\n\n" +
            studio.markdown_table(["suit", "samples lost", "not processed", "poses", "median, ms", "99.9 %, ms",
                                   "worst, ms", "slowest commit, ms"], rows))
    try:
        if seconds <= PROCESSED_S:
            text += ("\nThe take, processed with ranges between both. From second 11 on they turn and walk apart, back to "
                     "back: of 4300 ranges a second between them some 240 are heard, and their places drift:\n\n" + studio.markdown_table(
                ["A, mean degrees", "B, mean degrees", "pelvises, mm", "worst pair, mm", "heading, degrees"],
                [found_in_take(tape, take)]))
    finally:
        take.unlink()
    if missed:
        raise studio.Missed(missed, text)
    return text
