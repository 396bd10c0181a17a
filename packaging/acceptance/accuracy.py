# SPDX-License-Identifier: Apache-2.0
"""How far the poses are off on six real motions of different kind, 30 s each: every combination of sensors, with the
root given and free, filtered and smoothed, on the nominal scenario and on the realistic one after a guided movement."""
import calibration
import studio

SECONDS = 30
SENSORS = ("A", "D", "AD", "G", "GD", "AG", "AGD")
INERTIAL = ("AG", "GD", "AGD")
SMOOTHERS = ("none", "full")
MOTIONS = {"walk": studio.MORE_MOTIONS / "02_01.bvh", "boxer": studio.REAL_MOTIONS / "Boxing_Toes.bvh",
           "hops and turn": studio.REAL_MOTIONS / "01_01.bvh", "01_03": studio.REAL_MOTIONS / "01_03.bvh",
           "dance": studio.MORE_MOTIONS / "05_06.bvh",
           "walk and stop": studio.MORE_MOTIONS / "131_01.bvh"}


def evaluations(take, sensors, *options):
    """Without and with smoothing."""
    found = []
    for smoother in SMOOTHERS:
        name = " ".join(map(str, (sensors, smoother, *options)))
        studio.batch("process", take, "--sensors", sensors, "--smooth", smoother, "--run-name", name, *options)
        found.append(studio.evaluate(take, name))
    return found


def cell(found, value):
    return " → ".join(studio.number(value(evaluation)) for evaluation in found)


def degrees(evaluation):
    return evaluation["mean_deg"]


def nominal(folder):
    rows, free = [], []
    for name, motion in MOTIONS.items():
        if not motion.exists():
            continue
        take = folder / f"nominal_{motion.stem}.noctule"
        studio.simulate(motion, take, "--level", "readings", "--duration", SECONDS)
        found = {sensors: evaluations(take, sensors, "--root", "given") for sensors in SENSORS}
        rows.append([name, *(cell(found[sensors], degrees) for sensors in SENSORS),
                     cell(found["AGD"], lambda evaluation: evaluation["nees"])])
        one = evaluations(take, "AGD", "--root", "free")
        free.append([name, cell(one, degrees), *(cell(one, lambda evaluation, key=key: evaluation["root"][key])
                                                 for key in ("tilt_deg", "yaw_deg", "position_m"))])
    heads = ["motion", *("+".join(sensors) for sensors in SENSORS), "NEES of A+G+D"]
    return ("### Nominal, root given\n\n" + studio.markdown_table(heads, rows) +
            "\n### Nominal, root free, A+G+D\n\n" +
            studio.markdown_table(["motion", "joints, deg", "root's tilt, deg", "yaw, deg", "place, m"], free))


def realistic(folder):
    folder.mkdir(parents=True, exist_ok=True)
    _, (moved, performer) = calibration.guided_calibrations(folder)
    rows = []
    for name, motion in MOTIONS.items():
        if not motion.exists():
            continue
        take = folder / f"realistic_{motion.stem}.noctule"
        studio.batch("simulate", "--motion", motion, "--out", take, *calibration.MOVED, "--actor",
                     folder / "actor.json", "--duration", SECONDS, "--overwrite")
        found = {sensors: evaluations(take, sensors, "--root", "given", "--calibration", moved, "--actor", performer)
                 for sensors in INERTIAL}
        rows.append([name, *(cell(found[sensors], degrees) for sensors in INERTIAL),
                     cell(found["AGD"], lambda evaluation: evaluation["end_effector_mm"]),
                     cell(found["AGD"], lambda evaluation: evaluation["nees"])])
    heads = ["motion", *("+".join(sensors) for sensors in INERTIAL), "end effectors of A+G+D, mm", "NEES of A+G+D"]
    return "### Realistic, calibrated by a guided movement, root given\n\n" + studio.markdown_table(heads, rows)


def figure(_):
    folder = studio.OUT / "accuracy"
    folder.mkdir(parents=True, exist_ok=True)
    return (f"Mean angle to the reference over all joints in degrees, {SECONDS} s, readings level, filtered → smoothed "
            f"over the whole take.\n\n{nominal(folder)}\n{realistic(folder)}")
