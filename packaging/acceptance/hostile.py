# SPDX-License-Identifier: Apache-2.0
"""Every case of ../shared/data/hostile through the program: takes, boxes, announcements and clients made to do harm."""
import concurrent.futures
import dataclasses
import hashlib
import math
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

import studio

CASES = pathlib.Path(studio.ROOT).parent / "shared" / "data" / "hostile"
MOTION = "/usr/share/assimp/models/BVH/01_01.bvh"
RAW_CONTROLS = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]")
ACTIVE_HTML = re.compile(rb"<script|<img src=x")


@dataclasses.dataclass
class Limits:
    """What a program may take, and where it stands."""
    build: pathlib.Path = studio.BUILD
    longest_s: float = 30
    after_signal_s: float = 1.0
    take_kb: float = 500_000
    record_kb: float = 200_000
    takes_at_once: int = 1


PLAIN = Limits()
# Sanitizers cost time and memory of their own; what they find ends a program with a code that nothing else has.
SANITIZED = Limits(studio.ROOT / "build" / "asan-ubsan" / "bin", 300, 10, math.inf, math.inf, os.cpu_count() or 1)
FOUND_BY_SANITIZER = 99
ENVIRONMENT = {"QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8",
               "ASAN_OPTIONS": f"exitcode={FOUND_BY_SANITIZER}:detect_leaks=0",
               "UBSAN_OPTIONS": f"exitcode={FOUND_BY_SANITIZER}:halt_on_error=1:print_stacktrace=1"}


def program(limits, *words):
    return [str(limits.build / "noctule"), "--batch", *map(str, words)]


class Run:
    """One program under a watch: its exit code, the most memory, what it said, and when it heeded SIGINT."""

    def __init__(self, limits, words, folder, longest_s=None):
        command, self.limits = program(limits, *words), limits
        begin = time.monotonic()
        self.heeded_s = None
        with open(folder / "said", "w+b") as said:
            process = subprocess.Popen(command, stdout=said, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                       env={**os.environ, **ENVIRONMENT})
            ended = self.wait(process.pid, begin + (longest_s or limits.longest_s))
            if not ended:
                process.send_signal(signal.SIGINT)
                signalled = time.monotonic()
                ended = self.wait(process.pid, signalled + 5 * limits.after_signal_s)
                self.heeded_s = time.monotonic() - signalled
            if not ended:
                process.kill()
                ended = os.wait4(process.pid, 0)
            process.returncode = 0
            said.seek(0)
            self.said = said.read()
        self.seconds = time.monotonic() - begin
        self.code = os.waitstatus_to_exitcode(ended[1])
        self.memory_kb = ended[2].ru_maxrss

    @staticmethod
    def wait(pid, until):
        while time.monotonic() < until:
            ended = os.wait4(pid, os.WNOHANG)
            if ended[0]:
                return ended
            time.sleep(0.01)
        return None

    def faults(self, codes, most_kb):
        found = []
        heeded = self.code == 130 and self.heeded_s is not None and self.heeded_s <= self.limits.after_signal_s
        if self.code not in codes and not heeded:
            found.append(f"exit code {self.code}" +
                         (f": {self.said.decode(errors='replace')[:2000]}" if self.code == FOUND_BY_SANITIZER else ""))
        if self.heeded_s is not None and self.heeded_s > self.limits.after_signal_s:
            found.append(f"{self.heeded_s:.1f} s after SIGINT")
        if self.memory_kb > most_kb:
            found.append(f"{self.memory_kb // 1000} MB")
        if RAW_CONTROLS.search(self.said):
            found.append("raw control characters")
        return found


def make_takes(folder):
    base, readings = folder / "base_001.noctule", folder / "read_001.noctule"
    for path, words in ((base, ["--duration", "4"]), (readings, ["--duration", "6", "--level", "readings"])):
        subprocess.run(program(PLAIN, "simulate", "--motion", MOTION, *words, "--out", path, "--seed", "1", "--quiet"), check=True)
        subprocess.run(program(PLAIN, "process", path, "--root", "given", "--quiet"), check=True)
    takes = folder / "takes"
    subprocess.run([sys.executable, CASES / "make_takes.py", base, readings, takes], check=True)
    return base, sorted(takes.glob("*.noctule"))


def verbs(take, copy, out):
    """Name, words, whether the take may be changed."""
    return [("inspect", ["inspect", take], False), ("inspect --json", ["inspect", take, "--json"], False),
            ("evaluate", ["evaluate", take, "--report", out / "r.html"], False),
            ("export", ["export", take, "--bvh", out / "m.bvh", "--csv", out / "m.csv"], False),
            ("check", ["check", take], False), ("calibrate motion", ["calibrate", "motion", take, "--out", out / "c.json"], False),
            ("process", ["process", copy, "--root", "given"], True), ("process --out-dir", ["process", take, "--out-dir", out], False),
            ("attach", ["attach", copy, "--reference", MOTION, "--align", "0", "--overwrite"], True),
            ("recover", ["recover", copy], True)]


def digest(path):
    """In pieces: what this script holds counts as memory of the programs that it starts."""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").digest()


def integrity(path):
    import sqlite3
    try:
        database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
        return [row[0] for row in database.execute("PRAGMA integrity_check(1)")] == ["ok"]
    except sqlite3.Error as error:
        return str(error)


def try_take(limits, take, of_all, damaged):
    missed = []
    folder = of_all / take.stem
    folder.mkdir()
    before = digest(take)
    for name, words, writes in verbs(take, folder / "copy" / take.name, folder / "out"):
        for part in ("copy", "out"):
            shutil.rmtree(folder / part, ignore_errors=True)
            (folder / part).mkdir()
        if writes:
            shutil.copyfile(take, folder / "copy" / take.name)
        run = Run(limits, words, folder)
        codes = {3} if take.stem.startswith("view_") and name != "recover" else {0, 2, 3, 4, 6}
        faults = run.faults(codes, limits.take_kb)
        if writes and run.code == 0 and not damaged and integrity(folder / "copy" / take.name) is not True:
            faults.append("integrity_check")
        if (report := folder / "out" / "r.html").exists() and ACTIVE_HTML.search(report.read_bytes()):
            faults.append("active HTML")
        missed += [f"{take.stem}: {name}: {fault}" for fault in faults]
    if digest(take) != before:
        missed.append(f"{take.stem}: was changed")
    shutil.rmtree(folder)
    take.unlink()
    return missed


def names_in(script):
    """The cases that a script knows."""
    code = f"import sys; sys.path.insert(0, {str(CASES)!r}); import {script}; print(*{script}.CASES)"
    return subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True, check=True).stdout.split()


class Server:
    """bad_box.py or bad_announcer.py on a port of its own."""

    def __init__(self, script, case, port=0):
        self.process = subprocess.Popen([sys.executable, "-B", CASES / script, str(port), case], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.port = self.process.stdout.readline().strip()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()


def try_box(limits, case, folder):
    missed = []
    for more in ([], ["--keep-results"]):
        out = folder / "recorded"
        shutil.rmtree(out, ignore_errors=True)
        with Server("bad_box.py", case) as box:
            run = Run(limits, ["record", "--device", f"tcp://127.0.0.1:{box.port}", "--seconds", "3", "--out-dir", out, *more],
                      folder, longest_s=20)
        missed += [f"box {case}: {fault}" for fault in run.faults({0, 3, 4, 5}, limits.record_kb)]
        for take in out.glob("*.noctule"):
            seen = subprocess.run(program(PLAIN, "inspect", take, "--json"), capture_output=True)
            if seen.returncode != 0 or b'"state": "complete"' not in seen.stdout:
                missed.append(f"box {case}: its take is not complete")
    return missed


def try_announcer(limits, case, folder):
    with Server("bad_announcer.py", case) as announcer:
        run = Run(limits, ["devices", "--port", announcer.port, "--wait", "3"], folder, longest_s=10)
    return [f"announcer {case}: {fault}" for fault in run.faults({0}, limits.record_kb)]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return str(probe.getsockname()[1])


def try_clients(limits, base):
    tcp, control = free_port(), free_port()
    suit = subprocess.Popen([limits.build / "noctule-virtual-suit", "--take", base, "--loop", "--tcp", f"127.0.0.1:{tcp}",
                             "--control", f"127.0.0.1:{control}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        time.sleep(2)
        said = subprocess.run([sys.executable, "-B", CASES / "bad_studio.py", tcp, control], capture_output=True, text=True)
    finally:
        suit.kill()
        suit.wait()
    lines = said.stdout.splitlines()
    dead = [f"client: {line}" for line in lines if "alive" not in line]
    return len(lines), dead + ([] if said.returncode == 0 and lines else [f"client: {said.stderr[-300:]}"])


def measured(limits):
    missed = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        base, takes = make_takes(folder)
        with concurrent.futures.ThreadPoolExecutor(limits.takes_at_once) as pool:
            for found in pool.map(lambda take: try_take(limits, take, folder, damaged=take.stem == "schema_corrupt"), takes):
                missed += found
        boxes, announcers = names_in("bad_box"), names_in("bad_announcer")
        for case in boxes:
            missed += try_box(limits, case, folder)
        for case in announcers:
            missed += try_announcer(limits, case, folder)
        attacks, dead = try_clients(limits, base)
        missed += dead
    return missed, (f"{len(takes)} takes through ten verbs, {len(boxes)} driver boxes recorded with and without results, "
                    f"{len(announcers)} announcers, {attacks} attacks on the virtual suit. ")


def told(missed, text):
    text += f"\n\n{len(missed)} misses.\n\n"
    if missed:
        raise studio.Missed(missed, text + "".join(f"- {miss}\n" for miss in missed))
    return text


def figure(_):
    if not CASES.exists():
        return f"Skipped: {CASES} is missing."
    missed, text = measured(PLAIN)
    return told(missed, f"{text}Expected: documented exit codes, under 500 MB (200 MB for boxes), done in "
                f"{PLAIN.longest_s} s or ended {PLAIN.after_signal_s:.0f} s after SIGINT, no raw control characters, nothing "
                "active in a report, takes unchanged.")


def sanitized_figure(options):
    if not CASES.exists():
        return f"Skipped: {CASES} is missing."
    for command in (["cmake", "--preset", "asan-ubsan", "-D", "NOCTULE_STUDIO=OFF"],
                    ["cmake", "--build", "--preset", "asan-ubsan", "--parallel", str(options.jobs), "--target", "noctule",
                     "noctule-virtual-suit"]):
        subprocess.run(command, cwd=studio.ROOT, check=True, stdout=subprocess.DEVNULL)
    missed, text = measured(SANITIZED)
    return told(missed, f"{text}The same program built with the address and undefined-behaviour sanitizers: they find nothing, "
                f"and the rest holds but for memory, with {SANITIZED.longest_s} s each.")
