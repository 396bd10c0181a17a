# SPDX-License-Identifier: Apache-2.0
"""Five minutes of motion with and without distances: does the error grow (Vlasic 2007, figure 7)? An hour of it, and
five minutes of a person.

The angles are computed here from the take's pose and reference tables, apart from the program's own evaluation,
which stands beside them.
"""
import bisect
import json
import math
import resource
import struct

import calibration
import studio

SECONDS = 300
HOUR = 3600
EVERY = 14  # poses: ten compared instants a second


def unpack(blob):
    values = struct.unpack(f"<{len(blob) // 8}d", blob)
    return [values[i:i + 4] for i in range(0, len(values), 4)]


def angle_deg(a, b):
    dot = abs(sum(x * y for x, y in zip(a, b))) / math.sqrt(sum(x * x for x in a) * sum(y * y for y in b))
    return math.degrees(2 * math.acos(min(1.0, dot)))


def between(a, b, share):
    """Normalised linear interpolation; the reference's instants lie a few milliseconds apart."""
    sign = 1 if sum(x * y for x, y in zip(a, b)) >= 0 else -1
    return [(1 - share) * x + share * sign * y for x, y in zip(a, b)]


def moving_joints(database):
    actor = json.loads(database.execute("SELECT json FROM actor ORDER BY id DESC LIMIT 1").fetchone()[0])
    return [i for i, joint in enumerate(actor["joints"]) if i > 0 and joint["dof"]]


def rest_end_s(database):
    meta = dict(database.execute("SELECT key, value FROM meta"))
    row = database.execute("SELECT sample FROM marker WHERE kind = 'rest' AND label = 'end'").fetchone()
    return row[0] / int(meta["sample_rate_hz"]) if row else 0.0


def mean_angles(take, run):
    """[(seconds since the rest pose, degrees: mean over the joints that move)]."""
    with studio.open_take(take) as database:
        joints = moving_joints(database)
        begin_s = rest_end_s(database)
        reference = database.execute("SELECT time_ns, q FROM reference WHERE q NOT NULL ORDER BY time_ns").fetchall()
        poses = database.execute(
            "SELECT time_ns, q FROM pose JOIN derived USING (run) WHERE name = ? AND kind = 'pose' ORDER BY time_ns",
            (run,)).fetchall()
    times = [row[0] for row in reference]
    angles = []
    for time_ns, blob in poses[::EVERY]:
        after = bisect.bisect_left(times, time_ns)
        if time_ns * 1e-9 < begin_s or not 0 < after < len(times):
            continue
        share = (time_ns - times[after - 1]) / (times[after] - times[after - 1])
        before_q, after_q, q = unpack(reference[after - 1][1]), unpack(reference[after][1]), unpack(blob)
        errors = [angle_deg(q[j], between(before_q[j], after_q[j], share)) for j in joints]
        angles.append((time_ns * 1e-9 - begin_s, sum(errors) / len(errors)))
    return angles


def per_minute(angles):
    minutes = {}
    for seconds, angle in angles:
        minutes.setdefault(int(seconds // 60), []).append(angle)
    return [sum(values) / len(values) for _, values in sorted(minutes.items()) if len(values) > 60]


def slope_per_minute(angles):
    """Degrees a minute: the slope of the line through the angles."""
    n = len(angles)
    mean_t = sum(t for t, _ in angles) / n
    mean_a = sum(a for _, a in angles) / n
    spread = sum((t - mean_t) ** 2 for t, _ in angles)
    return 60 * sum((t - mean_t) * (a - mean_a) for t, a in angles) / spread


HEAD = ["sensors", "whole", "evaluate", "slope per minute", "by the minute"]


def row(name, take, sensors, *options):
    run = f"{sensors} {' '.join(map(str, options))}"
    studio.process(take, sensors, run, *options)
    evaluation = studio.evaluate(take, run)
    angles = mean_angles(take, run)
    return [name, f"{sum(a for _, a in angles) / len(angles):.3f}", studio.number(evaluation["mean_deg"], 3),
            f"{slope_per_minute(angles):+.4f}", " ".join(f"{angle:.2f}" for angle in per_minute(angles))]


def peak_mib():
    """Of the largest program that has been run."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def figure(options):
    motion = studio.REAL_MOTIONS / "01_01.bvh"
    folder = studio.OUT / "drift"
    take = folder / "drift_001.noctule"
    studio.simulate(motion, take, "--level", "readings", "--duration", SECONDS)
    minutes = [row("+".join(sensors), take, sensors) for sensors in ("G", "GD", "AG", "AGD")]

    _, (moved, performer) = calibration.guided_calibrations(folder)
    person = folder / "drift_person.noctule"
    studio.batch("simulate", "--motion", motion, "--out", person, *calibration.MOVED, "--actor", folder / "actor.json",
                 "--duration", SECONDS, "--overwrite")
    realistic = [row("+".join(sensors), person, sensors, "--calibration", moved, "--actor", performer)
                 for sensors in ("GD", "AG", "AGD")]

    hour = folder / "drift_hour.noctule"
    studio.simulate(motion, hour, "--level", "readings", "--duration", HOUR)
    hours = [row("A+G+D", hour, "AGD")]
    memory = peak_mib()
    hour.unlink()
    return (f"{motion.stem} repeated, readings level, root given. Degrees, mean over all joints; \"whole\" is computed "
            "from the take's tables, \"evaluate\" by the program, which takes a person's neck and head, two joints of the "
            "reference, as one.\n\n"
            f"### Nominal, {SECONDS} s\n\n{studio.markdown_table(HEAD, minutes)}\n"
            f"### Realistic, calibrated by a guided movement, {SECONDS} s\n\n"
            f"{studio.markdown_table(HEAD, realistic)}\n"
            f"### Nominal, an hour\n\n{studio.markdown_table(HEAD, hours)}\n"
            f"Memory of the largest program: {memory:.0f} MiB.\n")
