#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes sample.bvh, the motion behind "Try it with the virtual suit": 14 s at 60 Hz on the default actor's
skeleton, from the rest pose and back to it. The same bytes on every run.

  make_sample.py [OUT.bvh]      default: sample.bvh beside this script

Every movement is a row of GESTURES: an angle that is added to the rest pose, coming and going with minimum
jerk. The legs carry the body: its height and place follow from the standing leg.
"""
import math
import pathlib
import sys

FRAME_RATE_HZ = 60
DURATION_S = 14
THIGH_CM = SHIN_CM = 43.0
HIP_BELOW_ROOT_CM, ANKLE_HEIGHT_CM = 5.0, 6.0

# name, parent, offset in cm, order of the rotation channels (a joint's own freedoms first), tip
JOINTS = [
    ("Hips", None, (0, 0, 0), "ZXY", None),
    ("Spine", "Hips", (0, 6, 0), "ZXY", None),
    ("Chest", "Spine", (0, 12, 0), "ZXY", None),
    ("Neck", "Chest", (0, 26, 0), "ZXY", None),
    ("Head", "Neck", (0, 9, 1), "ZXY", (0, 24, 2)),
] + [joint for side, s in (("Left", 1), ("Right", -1)) for joint in [
    (side + "Shoulder", "Chest", (2 * s, 22, 0), "ZYX", None),
    (side + "Arm", side + "Shoulder", (15 * s, 0, 0), "ZXY", None),
    (side + "ForeArm", side + "Arm", (29 * s, 0, 0), "YXZ", None),
    (side + "Hand", side + "ForeArm", (25 * s, 0, 0), "ZYX", (18 * s, 0, 0)),
]] + [joint for side, s in (("Left", 1), ("Right", -1)) for joint in [
    (side + "UpLeg", "Hips", (9 * s, -5, 0), "ZXY", None),
    (side + "Leg", side + "UpLeg", (0, -43, 0), "XYZ", None),
    (side + "Foot", side + "Leg", (0, -43, 0), "ZXY", None),
    (side + "ToeBase", side + "Foot", (0, -6, 13), "ZXY", (0, 0, 6)),
]]

# The default actor's rest pose, left side; on the right Y and Z change sign.
REST_DEG = {("Arm", "Z"): -68.76, ("Arm", "Y"): -14.32, ("ForeArm", "Y"): -28.65}

# times in s: begins, is there, leaves, is gone; then joint and axis with degrees. "Both" mirrors the left side.
GESTURES = [
    # looks to the left, then to the right
    ((1.0, 1.7, 2.0, 2.8), {"Head.Y": 48, "Chest.Y": 9, "Head.X": 4}),
    ((2.1, 2.9, 3.2, 3.9), {"Head.Y": -46, "Chest.Y": -9}),
    # raises the right hand; the waving itself is in WAVE
    ((3.6, 4.5, 5.9, 6.7), {"RightArm.Z": -50, "RightArm.X": -76, "RightArm.Y": -12, "RightForeArm.Y": 66,
                            "RightShoulder.Z": -8, "Head.Y": -8, "Chest.Z": 2}),
    # reaches up with both arms and looks after them
    ((6.2, 7.4, 7.8, 8.9), {"BothArm.Z": 142, "BothArm.X": -42, "BothArm.Y": 14, "BothForeArm.Y": 18,
                            "BothShoulder.Z": 16, "Head.X": -22, "Chest.X": -6}),
    # bends the knees, arms forward for balance
    ((8.6, 9.5, 9.7, 10.6), {"knees": 78, "Spine.X": 16, "Chest.X": 10, "Head.X": -16, "BothArm.Y": -44,
                             "BothForeArm.Y": 10}),
    # a step on the spot with the left foot, one with the right; arms swing against the legs
    ((10.4, 10.8, 10.85, 11.25), {"LeftUpLeg.X": -36, "LeftLeg.X": 62, "LeftFoot.X": -17, "sway": 3.2,
                                  "LeftArm.Y": 16, "RightArm.Y": 24, "RightForeArm.Y": 14, "Chest.Y": 5}),
    ((11.25, 11.65, 11.7, 12.1), {"RightUpLeg.X": -36, "RightLeg.X": 62, "RightFoot.X": -17, "sway": -3.2,
                                  "RightArm.Y": -16, "LeftArm.Y": -24, "LeftForeArm.Y": -14, "Chest.Y": -5}),
    # turns the trunk to both sides
    ((11.8, 12.4, 12.5, 13.1), {"Spine.Y": 17, "Chest.Y": 19, "Head.Y": 14, "BothArm.Z": 8}),
    ((12.4, 13.0, 13.1, 13.7), {"Spine.Y": -17, "Chest.Y": -19, "Head.Y": -14, "BothArm.Z": 8}),
]
WAVE = ((4.3, 4.7, 5.6, 6.1), 1.6, {"RightForeArm.Y": 19, "RightHand.Y": 11})  # times, Hz, degrees
SOFT_KNEES = ((0.8, 1.6, 12.9, 13.8), {"knees": 9})
BREATH = (0.24, {"Chest.X": 0.8, "Head.X": -0.5, "BothShoulder.Z": 0.6})  # Hz, degrees


def minimum_jerk(x):
    x = min(max(x, 0.0), 1.0)
    return x * x * x * (10 - 15 * x + 6 * x * x)


def presence(times, t):
    """0 before and after, 1 while a gesture is fully there."""
    begin, there, leave, gone = times
    return minimum_jerk((t - begin) / (there - begin)) - minimum_jerk((t - leave) / (gone - leave))


def add(angles, what, degrees):
    if not what.startswith("Both"):
        angles[what] = angles.get(what, 0.0) + degrees
        return
    add(angles, "Left" + what[4:], degrees)
    add(angles, "Right" + what[4:], degrees if what.endswith("X") else -degrees)


def gestures_at(t):
    """Angles in degrees by "Joint.Axis", and "knees" and "sway" for both legs."""
    angles = {}
    for (joint, axis), degrees in REST_DEG.items():
        add(angles, f"Both{joint}.{axis}", degrees)
    rows = GESTURES + [SOFT_KNEES]
    times, frequency_hz, wave = WAVE
    rows = rows + [(times, {what: a * math.sin(2 * math.pi * frequency_hz * (t - times[0]))
                            for what, a in wave.items()})]
    frequency_hz, breath = BREATH
    rows = rows + [((0.2, 1.5, 12.5, 13.8), {what: a * math.sin(2 * math.pi * frequency_hz * t)
                                             for what, a in breath.items()})]
    for times, parts in rows:
        here = presence(times, t)
        for what, degrees in parts.items():
            add(angles, what, here * degrees)
    return angles


def stand(angles):
    """Bends both legs so that the soles stay flat, and returns where the root is, in cm."""
    knees, sway = angles.pop("knees", 0.0), angles.pop("sway", 0.0)
    for side in ("Left", "Right"):
        for joint, degrees in (("UpLeg.X", -knees / 2), ("Leg.X", knees), ("Foot.X", -knees / 2),
                               ("UpLeg.Z", sway), ("Foot.Z", -sway)):
            add(angles, side + joint, degrees)

    def reach_cm(side):
        hip = math.radians(angles[side + "UpLeg.X"])
        knee = hip + math.radians(angles[side + "Leg.X"])
        return THIGH_CM * math.cos(hip) + SHIN_CM * math.cos(knee)

    standing_cm = max(reach_cm("Left"), reach_cm("Right"))
    lean = math.radians(sway)
    return (-standing_cm * math.sin(lean),
            standing_cm * math.cos(lean) + HIP_BELOW_ROOT_CM + ANKLE_HEIGHT_CM, 0.0)


def hierarchy(name, depth=0):
    _, parent, offset, order, tip = next(joint for joint in JOINTS if joint[0] == name)
    pad = "\t" * depth
    yield f"{pad}{'JOINT' if parent else 'ROOT'} {name}"
    yield pad + "{"
    yield pad + "\tOFFSET {:.6f} {:.6f} {:.6f}".format(*offset)
    positions = "" if parent else "Xposition Yposition Zposition "
    yield f"{pad}\tCHANNELS {3 if parent else 6} {positions}" + " ".join(a + "rotation" for a in order)
    for child in JOINTS:
        if child[1] == name:
            yield from hierarchy(child[0], depth + 1)
    if tip:
        yield pad + "\tEnd Site"
        yield pad + "\t{"
        yield pad + "\t\tOFFSET {:.6f} {:.6f} {:.6f}".format(*tip)
        yield pad + "\t}"
    yield pad + "}"


def frame(t, names_in_file_order):
    angles = gestures_at(t)
    values = list(stand(angles))
    for name in names_in_file_order:
        order = next(joint[3] for joint in JOINTS if joint[0] == name)
        values += [angles.pop(f"{name}.{axis}", 0.0) for axis in order]
    assert not angles, f"no such channels: {sorted(angles)}"
    return " ".join(f"{value:.5f}" for value in values)


def main():
    path = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).with_name("sample.bvh")
    tree = list(hierarchy("Hips"))
    names = [line.split()[1] for line in tree if line.split()[0] in ("ROOT", "JOINT")]
    count = FRAME_RATE_HZ * DURATION_S
    lines = ["HIERARCHY"] + tree + ["MOTION", f"Frames: {count}", f"Frame Time: {1 / FRAME_RATE_HZ:.9f}"]
    lines += [frame(i / FRAME_RATE_HZ, names) for i in range(count)]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
