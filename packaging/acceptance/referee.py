# SPDX-License-Identifier: Apache-2.0
"""A referee for changes that must not move a digit: a fixed set of short simulated takes, the hash of every take's rows
and of the poses that come of them, compared with what referee.json holds for this kind of machine, or with what another
build makes of the same takes."""
import hashlib
import json
import pathlib
import platform
import random
import sqlite3
import subprocess

import studio

STORED = pathlib.Path(__file__).with_name("referee.json")
FOLDER = studio.OUT / "referee"
CLIPPED_RAD_S, GAP_BOARD = 4.0, 5
PARTIAL = ("Chest", "LeftArm", "RightArm", "LeftUpLeg")
# name: (motion, seconds, simulate's options, what is done to the take, {run: process' options})
CASES = {
    "readings": ("01_01", 6, ("--level", "readings"), None, {
        "AGD": ("--sensors", "AGD", "--root", "given"), "AGD free": ("--sensors", "AGD", "--root", "free"),
        "uneven": ("--sensors", "AG", "--root", "free", "--ground", "uneven"),
        "lag": ("--sensors", "AGD", "--root", "given", "--smooth", "lag"),
        "full": ("--sensors", "AGD", "--root", "free", "--smooth", "full"),
        "batch": ("--sensors", "AGD", "--root", "given", "--smooth", "batch")}),
    "sensor sets": ("01_03", 4, ("--level", "readings", "--seed", "2"), None, {
        sensors: ("--sensors", sensors, "--root", "given") for sensors in ("A", "G", "D", "AG", "AD", "GD")}),
    "paper": ("01_01", 4, ("--level", "readings", "--seed", "3"), None, {
        "paper": ("--sensors", "AGD", "--root", "given", "--estimator", "paper"),
        "paper sigma": ("--sensors", "GD", "--root", "given", "--estimator", "paper", "--paper-sigma", "1")}),
    "realistic": ("Boxing_Toes", 5, ("--level", "readings", "--scenario", "realistic", "--seed", "4"), None, {
        "AGD": ("--sensors", "AGD", "--root", "given"), "free": ("--sensors", "AGD", "--root", "free")}),
    "ideal": ("01_03", 3, ("--level", "readings", "--scenario", "ideal"), None, {
        "AGD": ("--sensors", "AGD", "--root", "given")}),
    "clipped": ("Boxing_Toes", 6, ("--level", "readings", "--seed", "5"), "clipped", {
        "AGD": ("--sensors", "AGD", "--root", "given")}),
    "partial": ("01_03", 4, ("--level", "readings", "--seed", "6"), "partial", {
        "AGD": ("--sensors", "AGD", "--root", "given"), "A": ("--sensors", "A", "--root", "given")}),
    "lost frames": ("01_01", 5, ("--level", "readings", "--seed", "7"), "lost", {
        "AGD": ("--sensors", "AGD", "--root", "free"),
        "full": ("--sensors", "AGD", "--root", "given", "--smooth", "full")}),
    "sound": ("01_01", 4, ("--seed", "8"), None, {
        "inflection": ("--sensors", "AGD", "--root", "given", "--detector", "inflection"),
        "matched": ("--sensors", "AGD", "--root", "given", "--detector", "matched"),
        "paper": ("--sensors", "AGD", "--root", "given", "--detector", "inflection", "--estimator", "paper")}),
    "sound with gaps": ("01_03", 4, ("--seed", "9", "--scenario", "realistic"), "gaps", {
        "matched": ("--sensors", "AGD", "--root", "free", "--detector", "matched")}),
}


def machine():
    """What the program's choice of instructions depends on; digits may differ between kinds."""
    flags = set()
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("flags"):
            flags = set(line.split(":")[1].split())
            break
    kind = "avx512" if "avx512f" in flags else "avx2" if {"avx2", "fma"} <= flags else "baseline"
    return f"{platform.machine()} {kind} {platform.libc_ver()[1]}"


def suit_for(what):
    suit = json.loads((studio.ROOT / "resources" / "suits" / "default.json").read_text())
    if what == "clipped":
        for board in suit["boards"]:
            board["gyro_full_scale_rad_s"] = CLIPPED_RAD_S
    if what == "partial":
        suit["boards"] = [board for board in suit["boards"] if board["segment"] not in PARTIAL]
    path = FOLDER / f"suit {what}.json"
    path.write_text(json.dumps(suit))
    return path


def damage(take, what):
    with sqlite3.connect(take) as database:
        if what == "lost":
            draw = random.Random(1)
            lost = [row for row in database.execute("SELECT board, frame FROM inertial ORDER BY board, frame")
                    if draw.random() < 0.03]
            database.executemany("DELETE FROM inertial WHERE board=? AND frame=?", lost)
        if what == "gaps":
            database.execute("DELETE FROM adc_block WHERE id IN (SELECT id FROM adc_block ORDER BY id LIMIT 2 OFFSET 5)")
            database.execute("INSERT INTO gap(suit, first_sample, sample_count, board, reason) "
                             "VALUES(1,400000,20000,?,'board')", (GAP_BOARD,))


def hash_rows(take, query, *values):
    digest = hashlib.sha256()
    with studio.open_take(take) as database:
        for row in database.execute(query, values):
            digest.update(repr(row).encode())
    return digest.hexdigest()[:16]


def hash_take(take):
    with studio.open_take(take) as database:
        tables = {name for name, in database.execute("SELECT name FROM sqlite_master WHERE type='table'")}
    queries = {"inertial": "SELECT * FROM inertial WHERE run=0 ORDER BY 2,3,4",
               "range": "SELECT * FROM range WHERE run=0 ORDER BY 2,4",
               "adc_block": "SELECT suit,first_sample,data FROM adc_block ORDER BY 1,2",
               "external_root": "SELECT * FROM external_root ORDER BY 1,2"}
    text = "".join(hash_rows(take, query) for table, query in queries.items() if table in tables)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def make(name, motion, seconds, options, what):
    take = FOLDER / f"{name}.noctule"
    suit = ("--suit", suit_for(what)) if what in ("clipped", "partial") else ()
    studio.batch("simulate", "--motion", studio.REAL_MOTIONS / f"{motion}.bvh", "--out", take, "--duration", seconds,
                 *suit, *options, "--overwrite")
    if what in ("lost", "gaps"):
        damage(take, what)
    return take


def pose_hashes(program, take, runs):
    """By run: the hash of all of its poses with their sigmas."""
    copies = FOLDER / "copies"
    copies.mkdir(exist_ok=True)
    copy = copies / take.name
    copy.write_bytes(take.read_bytes())
    found = {}
    for run, options in runs.items():
        command = [str(program), "--batch", "process", str(copy), "--run-name", run, *options]
        if "--detector" not in options:
            command += ["--detector", "inflection"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}")
        found[run] = hash_rows(copy, "SELECT time_ns,px,py,pz,q,sigma FROM pose WHERE run=(SELECT max(run) FROM "
                                     "derived WHERE kind='pose' AND name=?) ORDER BY time_ns", run)
    copy.unlink()
    return found


def figure(options):
    FOLDER.mkdir(parents=True, exist_ok=True)
    stored = json.loads(STORED.read_text()) if STORED.exists() else {}
    other = options.referee_against
    expected = stored.get(machine(), {})
    if not other and not expected and not options.referee_record:
        raise RuntimeError(f"referee.json holds nothing for {machine()}: give --referee-against PROGRAM of a build that "
                           "is right, or --referee-record")
    rows, moved, now = [], [], {}
    for name, (motion, seconds, with_options, what, runs) in CASES.items():
        take = make(name, motion, seconds, with_options, what)
        now[name] = {"take": hash_take(take), "poses": pose_hashes(studio.BUILD / "noctule", take, runs)}
        wanted = {"take": now[name]["take"], "poses": pose_hashes(other, take, runs)} if other else expected.get(name)
        for run, found in now[name]["poses"].items():
            if not wanted:
                verdict = "not stored yet"
            elif wanted["take"] != now[name]["take"]:
                verdict = "the simulated take is another one"
            else:
                verdict = "the same" if wanted["poses"].get(run) == found else "MOVED"
            if verdict not in ("the same", "not stored yet"):
                moved.append(f"{name}, {run}: {verdict}")
            rows.append([name, run, found, verdict])
    if options.referee_record:
        STORED.write_text(json.dumps({**stored, machine(): now}, indent=1, sort_keys=True) + "\n")
    table = studio.markdown_table(["take", "run", "hash", "verdict"], rows)
    text = (f"Hashes of poses and sigmas, {len(CASES)} takes, {len(rows)} runs, {machine()}"
            f"{', against another build' if other else ''}.\n\n{table}")
    if moved and not options.referee_record:
        raise studio.Missed(moved, text)
    return text
