# SPDX-License-Identifier: Apache-2.0
"""Where a free root goes: half a minute and five of walking, boxing and hops, with feet that hold it and without.

The place is compared here from the take's pose and reference tables; place and heading are made equal at the end of the
rest pose.
"""
import bisect
import math

import accuracy
import calibration
import drift
import studio

EVERY = 7  # poses: twenty compared instants a second
STEP = 5  # of those to one step along the path: what shakes within a quarter of a second is no way
NAMES = ("walk", "walk and stop", "boxer", "hops and turn")
SENSORS = ("AGD", "AG", "GD")


def heading(blob):
    w, x, y, z = drift.unpack(blob)[0]
    return math.atan2(2 * (w * y + x * z), 1 - 2 * (x * x + y * y))


def places(take, run):
    """(metres walked, [(metres off along the floor, metres too high, degrees turned off)])."""
    with studio.open_take(take) as database:
        begin_ns = drift.rest_end_s(database) * 1e9
        reference = database.execute(
            "SELECT time_ns, px, py, pz, q FROM reference WHERE q NOT NULL ORDER BY time_ns").fetchall()
        poses = database.execute("SELECT time_ns, px, py, pz, q FROM pose JOIN derived USING (run) "
                                 "WHERE name = ? AND kind = 'pose' AND time_ns >= ? ORDER BY time_ns",
                                 (run, begin_ns)).fetchall()
    times = [row[0] for row in reference]
    pairs = []
    for pose in poses[::EVERY]:
        after = bisect.bisect_left(times, pose[0])
        if after < len(times):
            pairs.append((pose, reference[after]))
    first, first_true = pairs[0]
    turn = heading(first[4]) - heading(first_true[4])
    errors = []
    for pose, true in pairs:
        x, y, z = (pose[i] - first[i] for i in (1, 2, 3))
        x, z = math.cos(turn) * x - math.sin(turn) * z, math.sin(turn) * x + math.cos(turn) * z
        true_x, true_y, true_z = (true[i] - first_true[i] for i in (1, 2, 3))
        turned = (heading(pose[4]) - heading(true[4]) - turn + math.pi) % (2 * math.pi) - math.pi
        errors.append((math.hypot(x - true_x, z - true_z), y - true_y, math.degrees(turned)))
    steps = [true for _, true in pairs][::STEP]
    path = sum(math.hypot(b[1] - a[1], b[3] - a[3]) for a, b in zip(steps, steps[1:]))
    return path, errors


def row(name, take, sensors, *options):
    cells = [name, "+".join(sensors)]
    for ground in ("none", "level"):
        run = f"{sensors} {ground}"
        studio.batch("process", take, "--sensors", sensors, "--ground", ground, "--run-name", run, *options)
        evaluation = studio.evaluate(take, run)
        path, errors = places(take, run)
        end, worst = errors[-1][0], max(error[0] for error in errors)
        cells += [studio.number(evaluation["mean_deg"]), studio.number(evaluation["root"]["tilt_deg"]),
                  f"{max(abs(error[2]) for error in errors):.1f}", f"{end:.2f} ({100 * end / path:.1f} %)",
                  f"{worst:.2f} ({100 * worst / path:.1f} %)", f"{max(abs(error[1]) for error in errors):.2f}"]
    return cells[:2] + [f"{path:.0f}"] + cells[2:]


def table(folder, scenario, seconds, simulate_with, options):
    rows = []
    for name in NAMES:
        motion = accuracy.MOTIONS[name]
        if not motion.exists():
            continue
        take = folder / f"{scenario}_{seconds}_{motion.stem}.noctule"
        studio.batch("simulate", "--motion", motion, "--out", take, *simulate_with, "--duration", seconds,
                     "--overwrite")
        rows += [row(name, take, sensors, *options) for sensors in SENSORS]
    each = ("joints, deg", "tilt, deg", "yaw at most, deg", "off at the end, m", "at most, m", "height at most, m")
    heads = ["motion", "sensors", "path, m", *each, *(f"held: {cell}" for cell in each)]
    return f"### {scenario.capitalize()}, {seconds} s\n\n{studio.markdown_table(heads, rows)}\n"


def figure(_):
    folder = studio.OUT / "ground"
    _, (moved, performer) = calibration.guided_calibrations(folder)
    nominal = ("--scenario", "nominal", "--level", "readings", "--seed", 1)
    realistic = (*calibration.MOVED, "--actor", folder / "actor.json")
    worn = ("--calibration", moved, "--actor", performer)
    return ("Root free, filtered, readings level; first `--ground none`, then held by feet that stand "
            "(`--ground level`).\n\n" +
            "\n".join(table(folder, "nominal", seconds, nominal, ()) + "\n" +
                      table(folder, "realistic", seconds, realistic, worn) for seconds in (30, 300)))
