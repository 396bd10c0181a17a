# SPDX-License-Identifier: Apache-2.0
"""Public motions and bodies as they come: read, right, or refused with the reason. Right is judged by a reader of
its own: lengths of limbs from the file's frames, and a head above the feet along the axis that is said to be up."""
import json
import math
import re
import statistics
import subprocess

import studio

SETS = studio.ROOT.parent / "shared" / "data"
MOST_FRAMES = 60
LIMBS = {"forearm": ("LeftForeArm", "LeftHand"), "thigh": ("LeftUpLeg", "LeftLeg"), "shin": ("LeftLeg", "LeftFoot"),
         "upper_arm": ("LeftArm", "LeftForeArm")}
LENGTH_TOLERANCE = 0.03
AXES = {"X": 0, "Y": 1, "Z": 2}


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def turned(matrix, vector):
    return [sum(matrix[i][k] * vector[k] for k in range(3)) for i in range(3)]


def rotation(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return {"X": [[1, 0, 0], [0, c, -s], [0, s, c]], "Y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
            "Z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis]


def read_bvh(path):
    """Joints (name, parent, offset, channels) and rows of numbers, of at most MOST_FRAMES frames."""
    head, motion = re.split(r"^\s*MOTION\s*$", path.read_text(encoding="utf-8", errors="replace"), 1, re.MULTILINE)
    joints, open_ones, in_site = [], [], False
    for line in head.splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] in ("ROOT", "JOINT"):
            joints.append([" ".join(words[1:]), open_ones[-1] if open_ones else -1, [0, 0, 0], []])
        elif words[0] == "End":
            in_site = True
        elif words[0] == "{":
            open_ones.append(-2 if in_site else len(joints) - 1)
        elif words[0] == "}":
            in_site = False if open_ones.pop() == -2 else in_site
        elif words[0] == "OFFSET" and not in_site:
            joints[-1][2] = [float(word) for word in words[1:4]]
        elif words[0] == "CHANNELS":
            joints[-1][3] = words[2:]
    numbers = [float(word) for word in motion.split("Frame Time:")[1].split()[1:]]
    width = sum(len(joint[3]) for joint in joints)
    rows = [numbers[i:i + width] for i in range(0, len(numbers) - width + 1, width)]
    return joints, rows[::max(1, len(rows) // MOST_FRAMES)]


def places(joints, row):
    """Where every joint is; position channels replace the OFFSET unless they are about zero beside it."""
    found, at = [], 0
    for _, parent, offset, channels in joints:
        own, turn = list(offset), [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        moved = [row[at + n] for n, channel in enumerate(channels) if channel.endswith("position")]
        adds = parent >= 0 and moved and max(map(abs, moved)) < 0.05 * math.hypot(*offset)
        for channel in channels:
            if channel.endswith("position") and not adds:
                own[AXES[channel[0]]] = row[at]
            elif channel.endswith("rotation"):
                turn = product(turn, rotation(channel[0], row[at]))
            at += 1
        if parent < 0:
            found.append((own, turn))
        else:
            there, above = found[parent]
            found.append(([a + b for a, b in zip(there, turned(above, own))], product(above, turn)))
    return [place for place, _ in found]


def faults(path, motion):
    """What the reader of its own contradicts."""
    joints, rows = read_bvh(path)
    index = {joint[0]: n for n, joint in enumerate(joints)}
    poses = [places(joints, row) for row in rows]
    named = motion["joints"]
    wrong = []
    for limb, (upper, lower) in LIMBS.items():
        if named.get(upper) not in index or named.get(lower) not in index:
            continue
        length = statistics.median(math.dist(pose[index[named[upper]]], pose[index[named[lower]]]) for pose in poses)
        length *= motion["metres_per_unit"]
        told = motion["measures_m"][limb]
        if abs(length - told) > LENGTH_TOLERANCE * told + 0.005:
            wrong.append(f"{limb} {told:.3f} m, the file shows {length:.3f} m")
    axis, sign = AXES[motion["up"][1]], 1 if motion["up"][0] == "+" else -1
    if named.get("Head") in index and named.get("LeftFoot") in index:
        above = sum(sign * (pose[index[named["Head"]]][axis] - pose[index[named["LeftFoot"]]][axis]) > 0
                    for pose in poses)
        if above < len(poses) / 2:
            wrong.append("its head is below its feet")
    return wrong


def run(*arguments):
    done = subprocess.run([str(studio.BUILD / "noctule"), "--batch", *map(str, arguments), "--json"],
                          capture_output=True, text=True)
    answer = json.loads(done.stdout) if done.stdout.strip() else {}
    return done.returncode, answer


def motion_rows(folder):
    rows, silent = [], []
    for path in sorted((SETS / "bvh").rglob("*.bvh")):
        code, answer = run("simulate", "--motion", path, "--out", folder / "motion.noctule", "--level", "readings",
                           "--duration", 2, "--rest-seconds", 0, "--scenario", "ideal", "--overwrite")
        if code != 0:
            rows.append([path.name, "refused", answer["error"]["message"].split(": ", 1)[-1]])
            continue
        motion = answer["motion"]
        wrong = faults(path, motion)
        verdict = "right" if not wrong else "wrong"
        said = f"{motion['height_m']:.2f} m, unit {motion['unit']}, {motion['up']} up, {len(motion['joints'])} joints, " \
               f"{motion['zero_pose']}, {len(motion['warnings'])} warnings"
        rows.append([path.name, verdict, "; ".join([said, *wrong])])
        if wrong and not motion["warnings"]:
            silent.append(path.name)
    return rows, silent


def body_rows(folder):
    take = folder / "sample.noctule"
    studio.batch("simulate", "--motion", studio.ROOT / "resources" / "motions" / "sample.bvh", "--out", take, "--level",
                 "readings", "--duration", 4, "--overwrite")
    studio.batch("process", take)
    rows = []
    for path in sorted((SETS / "fbx").glob("*.fbx")):
        as_body = run("export", take, "--glb", folder / "body.glb", "--mesh", path, "--overwrite")
        as_motion = run("simulate", "--motion", path, "--out", folder / "motion.noctule", "--level", "readings",
                        "--duration", 2, "--rest-seconds", 0, "--scenario", "ideal", "--overwrite")
        rows.append([path.name, *(outcome for each in (as_body, as_motion) for outcome in outcome_of(*each))])
    return rows


def outcome_of(code, answer):
    return (f"refused ({code})", answer["error"]["message"].split(": ", 1)[-1]) if code else ("read", "")


def figure(_):
    folder = studio.OUT / "motions"
    folder.mkdir(parents=True, exist_ok=True)
    motions, silent = motion_rows(folder)
    bodies = body_rows(folder)
    counts = {word: sum(row[1] == word for row in motions) for word in ("right", "wrong", "refused")}
    text = (f"Of {len(motions)} motions {counts['right']} are right, {counts['wrong']} wrong and "
            f"{counts['refused']} refused; {len(silent)} are wrong without a warning.\n\n"
            + studio.markdown_table(["motion", "verdict", "what was said"], motions)
            + "\nFBX as bodies (`export --mesh`) and as motions (`simulate --motion`); some are props or skeletons alone:\n\n"
            + studio.markdown_table(["file", "as a body", "reason", "as a motion", "reason"], bodies))
    if silent:
        raise studio.Missed([f"{name} is silently wrong" for name in silent], text)
    return text
