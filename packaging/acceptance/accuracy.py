# SPDX-License-Identifier: Apache-2.0
"""How far the poses are off on real motions of different kind, two dancers of one couple among them: every combination
of sensors, with the root given and free, filtered and smoothed, on the nominal scenario and on the realistic one after
a guided movement, beside a body that holds the rest pose."""
import concurrent.futures

import calibration
import drift
import studio

SECONDS = 30
SENSORS = ("A", "D", "AD", "G", "GD", "AG", "AGD")
SMOOTHERS = ("none", "full")
MOTIONS = {"walk": studio.MORE_MOTIONS / "02_01.bvh", "boxer": studio.REAL_MOTIONS / "Boxing_Toes.bvh",
           "hops and turn": studio.REAL_MOTIONS / "01_01.bvh", "01_03": studio.REAL_MOTIONS / "01_03.bvh",
           "dance": studio.MORE_MOTIONS / "05_06.bvh",
           "walk and stop": studio.MORE_MOTIONS / "131_01.bvh",
           "couple, one": studio.MORE_MOTIONS / "pair_salsa" / "60_05_scaled.bvh",
           "couple, other": studio.MORE_MOTIONS / "pair_salsa" / "61_05_scaled.bvh"}
SENSOR_HEADS = ["+".join(sensors) for sensors in SENSORS]
HEADS = ["motion", "rest pose held", *SENSOR_HEADS, "end effectors of A+G+D, mm", "NEES of A+G+D"]
FREE_HEADS = ["motion", *SENSOR_HEADS, "tilt of A+G+D's root, deg", "its yaw, deg", "its place, m"]


def evaluations(take, sensors, *options):
    """Without and with smoothing."""
    found = []
    for smoother in SMOOTHERS:
        name = " ".join(map(str, (sensors, smoother, *options)))
        studio.batch("process", take, "--sensors", sensors, "--smooth", smoother, "--run-name", name, *options)
        found.append(studio.evaluate(take, name))
    return found


def cell(values):
    return " → ".join(map(studio.number, values))


def rest_pose_deg(take):
    """What a body errs by that never leaves the rest pose: mean over the joints and over time."""
    with studio.open_take(take) as database:
        joints = drift.moving_joints(database)
        begin_ns = drift.rest_end_s(database) * 1e9
        poses = [(time_ns, drift.unpack(blob)) for time_ns, blob in
                 database.execute("SELECT time_ns, q FROM reference WHERE q NOT NULL ORDER BY time_ns")]
    rest = max(pose for pose in poses if pose[0] <= begin_ns)[1]
    moving = [q for time_ns, q in poses if time_ns > begin_ns][::drift.EVERY]
    return sum(drift.angle_deg(q[j], rest[j]) for q in moving for j in joints) / (len(moving) * len(joints))


def row_of(take, name, root, first, *options):
    """Of one take by every combination of sensors. `first`: cells that come before; after them, of A+G+D, end effectors
    and NEES or, of a free root, how far it is off."""
    found = {sensors: evaluations(take, sensors, "--root", root, *options) for sensors in SENSORS}
    best = found["AGD"]
    last = [[evaluation[key] for evaluation in best] for key in ("end_effector_mm", "nees")] if root == "given" else \
        [[evaluation["root"][key] for evaluation in best] for key in ("tilt_deg", "yaw_deg", "position_m")]
    return [name, *first, *(cell([evaluation["mean_deg"] for evaluation in pair]) for pair in found.values()),
            *map(cell, last)]


def tables(title, folder, jobs, simulate_with, process_with):
    def of_motion(item):
        name, motion = item
        take = folder / f"{title.split(',')[0].lower()}_{motion.stem}.noctule"
        studio.batch("simulate", "--motion", motion, "--out", take, *simulate_with, "--duration", SECONDS,
                     "--overwrite")
        given = row_of(take, name, "given", [studio.number(rest_pose_deg(take))], *process_with)
        return given, row_of(take, name, "free", [], *process_with)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        rows = list(pool.map(of_motion, (item for item in MOTIONS.items() if item[1].exists())))
    return (f"### {title}, root given\n\n{studio.markdown_table(HEADS, [given for given, _ in rows])}\n"
            f"### {title}, root free\n\n{studio.markdown_table(FREE_HEADS, [free for _, free in rows])}")


def figure(options):
    folder = studio.OUT / "accuracy"
    folder.mkdir(parents=True, exist_ok=True)
    _, (moved, performer) = calibration.guided_calibrations(folder)
    nominal = tables("Nominal", folder, options.jobs,
                     ("--scenario", "nominal", "--level", "readings", "--seed", 1), ())
    realistic = tables("Realistic, calibrated by a guided movement", folder, options.jobs,
                       (*calibration.MOVED, "--actor", folder / "actor.json"),
                       ("--calibration", moved, "--actor", performer))
    return (f"Mean angle to the reference over all joints in degrees, {SECONDS} s, readings level, filtered → smoothed "
            f"over the whole take.\n\n{nominal}\n{realistic}")
