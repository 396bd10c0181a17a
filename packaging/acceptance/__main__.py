# SPDX-License-Identifier: Apache-2.0
"""Runs figures by name and keeps them in one dated Markdown file. A new figure is a new module and a line here."""
import argparse
import datetime
import os
import re
import subprocess
import sys
import time

import accessibility
import accuracy
import benchmarks
import beside
import blender
import bounds
import calibration
import cast
import cast_live
import drift
import fuzz
import ground
import hostile
import interface
import kills
import live
import long_fuzz
import motions
import partial
import real
import record
import referee
import robot
import rooms
import sanitizers
import speed
import studio
import table1

FIGURES = {
    "table1": ("Table 1: combinations of sensors, both estimators", table1.figure),
    "accuracy": ("Accuracy on real motions, filtered and smoothed", accuracy.figure),
    "partial": ("Suits with boards left out", partial.figure),
    "referee": ("Poses that must stay the same to the bit", referee.figure),
    "drift": ("Drift over five minutes and an hour", drift.figure),
    "bounds": ("Bounds, floors and starts", bounds.figure),
    "ground": ("Where a free root goes", ground.figure),
    "benchmarks": ("Benchmarks", benchmarks.figure),
    "speed": ("Speed on one core", speed.figure),
    "studio": ("The studio: start, a long take, memory", interface.figure),
    "live": ("A whole suit in real time", live.figure),
    "record": ("A live take through the studio", record.figure),
    "accessibility": ("The studio over AT-SPI", accessibility.figure),
    "blender": ("Exports opened in Blender", blender.figure),
    "calibration": ("Calibration", calibration.figure),
    "cast": ("Several people: Welch 2018, section 4, and two whole suits", cast.figure),
    "cast-live": ("Two whole suits in real time, into one take", cast_live.figure),
    "rooms": ("One performer in a room of four anchors", rooms.figure),
    "real": ("Recordings of real sensors, takes made elsewhere", real.figure),
    "robot": ("Robots: kinematics, following, limits, six trajectories, the live chain and its faults", robot.figure),
    "kills": ("Recordings that are killed, without power, with every fault", kills.figure),
    "beside": ("A recording beside other programs", beside.figure),
    "motions": ("Public motions and bodies: read, right or refused", motions.figure),
    "hostile": ("Takes, boxes, announcements and clients made to do harm", hostile.figure),
    "hostile-sanitized": ("The same under sanitizers", hostile.sanitized_figure),
    "fuzz": ("Damaged bytes into every reader", fuzz.figure),
    "sanitizers": ("Unit tests under sanitizers", sanitizers.figure),
    "long-fuzz": ("Damaged inputs", long_fuzz.figure),
}


def parse_options():
    parser = argparse.ArgumentParser(prog="packaging/acceptance.sh", description="The full figures, by name.")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"{', '.join(FIGURES)} or all")
    parser.add_argument("--paper-sigma", type=float, metavar="X",
                        help="the paper estimator's second process sigma; default: the best of "
                             f"{', '.join(map(str, table1.SIGMAS_TO_TRY))}")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="programs at a time")
    parser.add_argument("--kills", type=int, default=200, metavar="N", help="and as many power failures")
    parser.add_argument("--calibration-trials", type=int, default=50, metavar="N", help="suits of each calibration")
    parser.add_argument("--damaged-inputs", type=int, default=1_000_000, metavar="N", help="of fuzz, each reader")
    parser.add_argument("--damaged-meshes", type=int, default=1000, metavar="N", help="of fuzz")
    parser.add_argument("--fuzz-inputs", type=int, default=20000, metavar="N")
    parser.add_argument("--fuzz-seed", type=int, default=1, metavar="N")
    parser.add_argument("--room-seeds", type=int, default=20, metavar="N", help="of rooms: takes of each scenario")
    parser.add_argument("--cast-seeds", type=int, default=20, metavar="N", help="of cast: handshakes of two whole suits")
    parser.add_argument("--cast-salsa-seeds", type=int, default=3, metavar="N", help="of cast: dances of two whole suits")
    parser.add_argument("--cast-paper-seeds", type=int, default=20, metavar="N", help="of cast: the paper's section 4")
    parser.add_argument("--cast-live-seconds", type=int, default=300, metavar="N",
                        help="of cast-live; up to 60 the take is processed and judged, too")
    parser.add_argument("--live-seconds", type=int, default=600, metavar="N", help="of live")
    parser.add_argument("--robot-seconds", type=int, default=600, metavar="N", help="of robot: the soak of the live chain")
    parser.add_argument("--studio-rounds", type=int, default=interface.ROUNDS_PER_HOUR, metavar="N",
                        help="of drive_studio, each what is done in a minute; at least 4")
    parser.add_argument("--referee-against", metavar="PROGRAM", help="of referee: another build to compare with")
    parser.add_argument("--referee-record", action="store_true", help="of referee: keep the hashes of this build")
    parser.add_argument("--check", action="store_true", help="only look at the arguments")
    options = parser.parse_args()
    names = list(FIGURES) if "all" in options.names else options.names
    unknown = sorted(set(names) - set(FIGURES))
    if unknown or not names:
        parser.error(f"no figure named {', '.join(unknown)}" if unknown else "name a figure, or all")
    options.names = names
    return options


def state_of_the_sources():
    def git(*arguments):
        return subprocess.run(["git", "-C", studio.ROOT, *arguments], capture_output=True, text=True).stdout.strip()

    changed = " with uncommitted changes" if git("status", "--porcelain", "--untracked-files=no") else ""
    return (git("rev-parse", "--short=12", "HEAD") or "unknown") + changed


def put_section(text, name, body):
    """Replaces or appends what stands between the two comments that carry the figure's name."""
    section = f"<!-- begin {name} -->\n{body.rstrip()}\n<!-- end {name} -->\n"
    pattern = re.compile(rf"<!-- begin {name} -->\n.*?<!-- end {name} -->\n", re.DOTALL)
    return pattern.sub(lambda _: section, text) if pattern.search(text) else text + "\n" + section


def write_aside(path, text):
    aside = path.with_name(path.name + ".new")
    aside.write_text(text)
    aside.replace(path)


def run_figure(name, options):
    """Its section, and what it missed."""
    title, figure = FIGURES[name]
    print(f"== {name}", file=sys.stderr)
    begin = time.monotonic()
    missed = None
    try:
        body = figure(options)
    except studio.Missed as error:
        body, missed = error.text, error
    note = f"Sources {state_of_the_sources()}, {os.cpu_count()} cores, {time.monotonic() - begin:.0f} s: "
    return f"## {title}\n\n{body.rstrip()}\n\n{note}`packaging/acceptance.sh {name}`\n", missed


def main():
    options = parse_options()
    if options.check:
        return 0
    today = datetime.date.today().isoformat()
    studio.OUT.mkdir(parents=True, exist_ok=True)
    path = studio.OUT / f"{today}.md"
    results = path.read_text() if path.exists() else f"# Figures of {today}\n"
    failed = []
    for name in options.names:
        try:
            section, missed = run_figure(name, options)
            results = put_section(results, name, section)
            write_aside(path, results)
            if missed:
                raise missed
        except (RuntimeError, OSError, KeyError) as error:
            failed.append(name)
            print(f"{name} failed: {error}", file=sys.stderr)
    print(f"figures in {path}" + (f"; failed: {', '.join(failed)}" if failed else ""))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
