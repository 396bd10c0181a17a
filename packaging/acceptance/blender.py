# SPDX-License-Identifier: Apache-2.0
"""The exported BVH opened in Blender, the program that most animators open it in: are the joints where our CSV of
the same run says?"""
import csv
import json
import pathlib
import shutil
import subprocess

import studio

FPS = 60
LARGEST_MM = 0.1  # Blender holds a bone's place as float32, BVH angles have six decimals
INSIDE = pathlib.Path(__file__).with_name("inside_blender.py")
PRESETS = {"blender": 1.0, "motionbuilder": 0.01}  # and the scale to import with


def blender():
    """The program; a figure's own dependency, as big as all others together."""
    if not shutil.which("blender"):
        raise RuntimeError("blender is not installed: apt-get install --no-install-recommends blender")
    return "blender"


def joints_in_blender(bvh, scale, fps):
    """[{joint: (x, y, z)} per frame], in our world's axes and metres."""
    done = subprocess.run([blender(), "-b", "--factory-startup", "--python", INSIDE, "--", bvh, str(scale), str(fps)],
                          capture_output=True, text=True)
    lines = [line for line in done.stdout.splitlines() if line.startswith("JOINTS ")]
    if len(lines) != 1:
        raise RuntimeError(f"Blender could not open {bvh}:\n{done.stdout[-1500:]}{done.stderr[-1500:]}")
    return json.loads(lines[0].removeprefix("JOINTS "))


def joints_in_csv(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    names = [column.removesuffix(".x") for column in rows[0] if column.endswith(".x")]
    return [{name: [float(row[f"{name}.{axis}"]) for axis in "xyz"] for name in names} for row in rows]


def largest_difference_mm(bvh, scale, expected):
    seen = joints_in_blender(bvh, scale, FPS)
    if len(seen) != len(expected):
        raise RuntimeError(f"{bvh}: Blender sees {len(seen)} frames, the CSV has {len(expected)}")
    missing = sorted(set(expected[0]) - set(seen[0]))
    if missing:
        raise RuntimeError(f"{bvh}: Blender does not see {', '.join(missing)}")
    return max(1000 * max(abs(a - b) for a, b in zip(frame[name], places))
               for frame, row in zip(seen, expected) for name, places in row.items())


def figure(_):
    folder = studio.OUT / "blender"
    rows = []
    for motion in ("Boxing_Toes", "01_01"):
        take = folder / f"{motion}.noctule"
        studio.simulate(studio.REAL_MOTIONS / f"{motion}.bvh", take, "--level", "readings", "--duration", 20)
        studio.process(take, "AGD", "AGD")
        for preset, scale in PRESETS.items():
            bvh, table = folder / f"{motion}_{preset}.bvh", folder / f"{motion}.csv"
            studio.batch("export", take, "--bvh", bvh, "--csv", table, "--preset", preset, "--fps", FPS,
                         "--overwrite")
            expected = joints_in_csv(table)
            worst = largest_difference_mm(bvh, scale, expected)
            if worst > LARGEST_MM:
                raise RuntimeError(f"{bvh}: a joint lies {worst:.2f} mm off in Blender")
            rows.append([motion, preset, len(expected), len(expected[0]), studio.number(worst, 4)])
    return studio.markdown_table(["motion", "preset", "frames", "joints", "largest difference, mm"], rows)
