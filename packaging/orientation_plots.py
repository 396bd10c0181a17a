# SPDX-License-Identifier: Apache-2.0
"""Draws how far orientations are off over a trial, as resources/docs/orientation_*.svg, from the takes that
`packaging/acceptance.sh real` leaves in out/acceptance/real."""
import contextlib
import math
import pathlib
import sqlite3
import struct

ROOT = pathlib.Path(__file__).resolve().parents[1]
TAKES = ROOT / "out" / "acceptance" / "real"
TRIALS = {"02": "slow_rotation", "16": "fast_translation", "30": "magnet_nearby"}
RUNS = {"miller": "#d1495b", "miller, reading levelled": "#edae49", "bachmann": "#66a182", "noctule": "#2e6fbb"}
WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 720, 240, 46, 34, 30
STEP_S, MOST_DEG = 0.5, 60


def angle_deg(a, b):
    dot = abs(sum(x * y for x, y in zip(a, b)))
    return math.degrees(2 * math.acos(min(1.0, dot)))


def curve(database, run, truth):
    """(second, largest error within STEP_S)"""
    largest = {}
    rows = database.execute("SELECT o.time_ns, o.qw, o.qx, o.qy, o.qz FROM orientation o JOIN derived d ON d.run = o.run "
                            "WHERE d.name = ? AND d.kind = 'orientation' ORDER BY o.time_ns", (run,))
    for time_ns, *q in rows:
        reference = truth.get(time_ns // 1000)
        if reference:
            bin_ = int(time_ns * 1e-9 / STEP_S)
            largest[bin_] = max(largest.get(bin_, 0), angle_deg(q, reference))
    return [(bin_ * STEP_S, error) for bin_, error in sorted(largest.items())]


def phases(database):
    rate = int(dict(database.execute("SELECT key, value FROM meta"))["sample_rate_hz"])
    marks = list(database.execute("SELECT sample, label FROM marker WHERE kind = 'movement' ORDER BY sample"))
    begins = [sample / rate for sample, label in marks if label == "begin"]
    ends = [sample / rate for sample, label in marks if label == "end"]
    return list(zip(begins, ends))


def drawing(title, curves, moving):
    seconds = max(t for points in curves.values() for t, _ in points)
    x = lambda t: LEFT + (WIDTH - LEFT - 10) * t / seconds
    y = lambda deg: HEIGHT - BOTTOM - (HEIGHT - BOTTOM - TOP) * min(deg, MOST_DEG) / MOST_DEG
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
             'font-family="sans-serif" font-size="11">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>']
    parts += [f'<rect x="{x(a):.1f}" y="{TOP}" width="{x(b) - x(a):.1f}" height="{HEIGHT - BOTTOM - TOP}" fill="#eef1f5"/>'
              for a, b in moving]
    for deg in range(0, MOST_DEG + 1, 20):
        parts.append(f'<line x1="{LEFT}" x2="{WIDTH - 10}" y1="{y(deg):.1f}" y2="{y(deg):.1f}" stroke="#c8ccd2"/>'
                     f'<text x="{LEFT - 6}" y="{y(deg) + 4:.1f}" text-anchor="end">{deg}°</text>')
    for t in range(0, int(seconds) + 1, 30):
        parts.append(f'<text x="{x(t):.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{t} s</text>')
    at = LEFT
    parts.append(f'<text x="{LEFT}" y="13" font-weight="bold">{title}</text>')
    for run, points in curves.items():
        line = " ".join(f"{x(t):.1f},{y(deg):.1f}" for t, deg in points)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{RUNS[run]}" stroke-width="1.3"/>')
        parts.append(f'<text x="{at}" y="26" fill="{RUNS[run]}">{run}</text>')
        at += 24 + 6.2 * len(run)
    return "\n".join(parts) + "\n</svg>\n"


def main():
    for number, name in TRIALS.items():
        take = TAKES / f"broad_{number}.noctule"
        with contextlib.closing(sqlite3.connect(take.as_uri() + "?mode=ro", uri=True)) as database:
            truth = {time_ns // 1000: struct.unpack("<4d", q)
                     for time_ns, q in database.execute("SELECT time_ns, q FROM reference WHERE q IS NOT NULL")}
            curves = {run: curve(database, run, truth) for run in RUNS}
            title = f"BROAD {number}, {name.replace('_', ' ')}: largest total error in each half second; grey: moving"
            text = drawing(title, curves, phases(database))
        (ROOT / "resources" / "docs" / f"orientation_{name}.svg").write_text(text)


if __name__ == "__main__":
    main()
