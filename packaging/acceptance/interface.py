# SPDX-License-Identifier: Apache-2.0
"""What the studio asks of the one who waits for it: how long until it is there, until a long take is open, until a
frame follows the cursor, and whether it ever stops answering; and whether an hour of use leaves its memory as it was."""
import json
import re
import statistics
import subprocess
import time

import built_tests
import screen
import studio

STARTS = 7
LONGEST_START_MS = 1500
FIRST_FRAME = re.compile(rb"first frame (\d+) ms after the start of the process")
PATIENCE_S = 60
LONG_TAKE_S = 600
LONGEST_OPENING_MS, LONGEST_STEP_MS, LONGEST_STALL_MS = 2000, 40, 50
# A day of eight hours may add a third to the 300 MB or so that the studio takes; what only grows is a leak.
MOST_GROWTH_MB_PER_HOUR = 12
ROUNDS_PER_HOUR = 60  # of drive_studio: each is what is done in a minute


def first_frame_ms(display):
    """Of one start in a home folder without settings; by the program's own word (noctule.startup)."""
    with screen.own_home(display, QT_LOGGING_RULES="noctule.startup=true") as environment:
        program = subprocess.Popen([studio.BUILD / "noctule"], stderr=subprocess.PIPE, env=environment,
                                   stdout=subprocess.DEVNULL)
        try:
            begin = time.monotonic()
            for line in program.stderr:
                if found := FIRST_FRAME.search(line):
                    return int(found[1])
                if time.monotonic() - begin > PATIENCE_S:
                    break
            raise RuntimeError("the studio did not tell when its first frame was there")
        finally:
            program.kill()
            program.wait()
            program.stderr.close()


def startup(missed):
    with screen.own_screen() as display:
        times = [first_frame_ms(display) for _ in range(STARTS)]
    middle, worst = statistics.median(times), max(times)
    if middle > LONGEST_START_MS:
        missed.append(f"the first frame takes {middle:.0f} ms in the middle of {STARTS} starts")
    return ("### Start\n\nFrom the start of the process to the first painted frame with a running event loop, under "
            "Xvfb, each time with a new home folder; "
            f"at most {LONGEST_START_MS} ms in the middle of {STARTS} starts.\n\n"
            +
            studio.markdown_table(["starts", "median, ms", "worst, ms", "all, ms"],
                                  [[STARTS, f"{middle:.0f}", worst, ", ".join(map(str, times))]]))


def take_of(name, motion, seconds):
    """Processed; made once, it stays for the next time."""
    take = studio.OUT / "studio" / f"{name}.noctule"
    done = take.with_suffix(".done")
    if not done.exists():
        studio.simulate(studio.REAL_MOTIONS / f"{motion}.bvh", take, "--level", "readings", "--duration", seconds)
        studio.process(take, "AGD", "AGD")
        done.touch()
    return take


def waiting(missed):
    take = take_of("ten_minutes", "01_01", LONG_TAKE_S)
    with screen.own_screen() as display, screen.own_home(display, NOCTULE_BENCH_TAKE=str(take)) as environment:
        done = subprocess.run([studio.BUILD / "bench_studio", "--benchmark_format=json"], capture_output=True,
                              text=True, env=environment)
    if done.returncode != 0:
        raise RuntimeError(f"bench_studio: exit code {done.returncode}\n{done.stderr[-2000:]}")
    rows = []
    for run in json.loads(done.stdout)["benchmarks"]:
        name = run["name"].split("/iterations")[0]
        if "error_message" in run:
            raise RuntimeError(f"{name}: {run['error_message']}")
        limit = LONGEST_OPENING_MS if name == "opening" else LONGEST_STEP_MS
        if run["real_time"] > limit:
            missed.append(f"{name} takes {run['real_time']:.0f} ms, {limit} ms are allowed")
        busy = f"{run['busy_ms']:.1f}" if "busy_ms" in run else ""
        rows.append([name, f"{run['real_time']:.1f}", f"{run['worst_ms']:.1f}", busy, limit])
    head = ["what", "mean, ms", "worst, ms", "computed by the interface, ms", "limit of the mean"]
    return (f"### A take of {LONG_TAKE_S // 60} minutes\n\nFrom the click to a body that moves and plots that show; "
            "from a move of the cursor to the painted 3D view and plots, window 1440 x 900.\n\n" +
            studio.markdown_table(head, rows))


def stalls(missed):
    text = ""
    for program, cases in (("test_ui_main_window", "Stalls.*:ConnectFlow.WatchingASuitHoldsNothingUp"),
                           ("test_ui_models", "LiveSuitTest.TheInterfaceNeverWaits")):
        with screen.own_screen() as display, screen.own_home(display, NOCTULE_ALONE="1") as environment:
            try:
                text += built_tests.run(program, cases, "longest gap", environment)
            except studio.Missed as error:
                text += error.text
                missed.append(str(error))
    return ("### Stalls\n\nThe longest time in which the interface did not answer, and what of it is not the machine's "
            f"(no core was free); at most {LONGEST_STALL_MS} ms.\n\n{text}")


def slope(values):
    """Of the line through values[0], values[1], ..., per step."""
    n = len(values)
    middle, mean = (n - 1) / 2, sum(values) / n
    spread = sum((i - middle) ** 2 for i in range(n))
    return sum((i - middle) * (value - mean) for i, value in enumerate(values)) / spread


def memory(rounds, missed):
    takes = [take_of("hour_boxer", "Boxing_Toes", 10), take_of("hour_hops", "01_01", 10)]
    with screen.own_screen() as display, screen.own_home(display) as environment:
        done = subprocess.run([studio.BUILD / "drive_studio", *takes, str(rounds)], capture_output=True, text=True,
                              env=environment)
    found = [(float(a), float(b)) for a, b in re.findall(r"resident_mb ([\d.]+) in_use_mb ([\d.]+)", done.stdout)]
    if done.returncode != 0 or len(found) != rounds:
        raise RuntimeError(f"drive_studio ended in round {len(found) + 1}, exit code {done.returncode}\n"
                           f"{done.stderr[-2000:]}")
    later = found[rounds // 2:]
    growth, in_use = (ROUNDS_PER_HOUR * slope([pair[i] for pair in later]) for i in (0, 1))
    if growth > MOST_GROWTH_MB_PER_HOUR:
        missed.append(f"memory grows by {growth:.1f} MB an hour")
    rows = [[i + 1, f"{found[i][0]:.0f}", f"{found[i][1]:.0f}"]
            for i in sorted({0, rounds // 4, rounds // 2, 3 * rounds // 4, rounds - 1})]
    return (f"### Memory\n\n{rounds} rounds, each with the operations of a minute of use (open, look, play, scrub, all "
            "pages, themes; each sixth processes and exports), what is played shortened. Over the later half resident "
            f"memory grows by {growth:+.1f} MB and what is in use by {in_use:+.1f} MB per {ROUNDS_PER_HOUR} rounds; "
            f"allowed are {MOST_GROWTH_MB_PER_HOUR}.\n\n" +
            studio.markdown_table(["round", "resident, MB", "in use, MB"], rows))


def figure(options):
    missed = []
    text = "\n".join([startup(missed), waiting(missed), stalls(missed), memory(options.studio_rounds, missed)])
    if missed:
        raise studio.Missed(missed, text)
    return text
