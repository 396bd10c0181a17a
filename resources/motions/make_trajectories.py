#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes trajectories/*.bvh: the six movements of the right hand of Miller, Jenkins, Kallmann, Mataric 2004,
"Motion capture from inertial sensing for untethered humanoid teleoperation", figure 9: vertical, horizontal,
diagonal, circle, box, infinity. The same bytes on every run.

  make_trajectories.py [FOLDER]      default: trajectories beside this script

The skeleton is that of make_sample.py. From hanging, the hand goes to the middle of the figure, follows it
twice in the plane ahead of the body, and comes back: every motion begins and ends in one posture.
"""
import math
import pathlib
import sys

from make_sample import JOINTS, hierarchy, minimum_jerk

FRAME_RATE_HZ = 30
APPROACH_S, ROUND_S, ROUNDS = 2.0, 5.0, 2
UPPER_CM, FOREARM_CM = 29.0, 25.0
MIDDLE_CM = (-4.0, -12.0, 36.0)  # from the right shoulder: x to the left, y up, z ahead
HALF_CM = 13.0
ROOT_CM = (0.0, 97.0, 0.0)
CORNERS = [(0, 1), (1, 1), (1, -1), (-1, -1), (-1, 1), (0, 1)]


def there_and_back(t, x, y):
    s = math.sin(2 * math.pi * t)
    return x * s, y * s


def box(t):
    """Along the edges, resting at each corner; from the middle to the edge and back in the first and last eighth."""
    stations = [(0, 0)] + CORNERS + [(0, 0)]
    lengths = [math.dist(a, b) for a, b in zip(stations, stations[1:])]
    way = t * sum(lengths)
    for a, b, length in zip(stations, stations[1:], lengths):
        if way <= length:
            part = minimum_jerk(way / length)
            return tuple(p + (q - p) * part for p, q in zip(a, b))
        way -= length
    return 0, 0


def circle(t):
    """Out of the middle in the first eighth, once round, back in the last."""
    radius = minimum_jerk(8 * t) * minimum_jerk(8 * (1 - t))
    angle = 2 * math.pi * t
    return radius * math.sin(angle), radius * math.cos(angle)


SHAPES = {
    "vertical": lambda t: there_and_back(t, 0, 1),
    "horizontal": lambda t: there_and_back(t, 1, 0),
    "diagonal": lambda t: there_and_back(t, math.sqrt(0.5), math.sqrt(0.5)),
    "circle": circle,
    "box": box,
    "infinity": lambda t: (math.sin(2 * math.pi * t), 0.5 * math.sin(4 * math.pi * t)),
}


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def rotation_to(a, b):
    """The smallest rotation that takes unit vector a to b, as rows."""
    v, c = cross(a, b), dot(a, b)
    k = 1 / (1 + c)
    return [[c + v[0] * v[0] * k, v[0] * v[1] * k - v[2], v[0] * v[2] * k + v[1]],
            [v[1] * v[0] * k + v[2], c + v[1] * v[1] * k, v[1] * v[2] * k - v[0]],
            [v[2] * v[0] * k - v[1], v[2] * v[1] * k + v[0], c + v[2] * v[2] * k]]


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def transposed(a):
    return [list(row) for row in zip(*a)]


def apply(a, v):
    return tuple(dot(row, v) for row in a)


def euler_deg(R, order):
    """Angles of R = R_a(x) R_b(y) R_c(z) for the axes a, b, c of the order, all three different."""
    a, b, c = ("XYZ".index(axis) for axis in order)
    sign = 1 if (b - a) % 3 == 1 else -1
    middle = math.asin(max(-1.0, min(1.0, sign * R[a][c])))
    first = math.atan2(-sign * R[b][c], R[c][c])
    last = math.atan2(-sign * R[a][b], R[a][a])
    return [math.degrees(x) for x in (first, middle, last)]


def arm_to(hand_cm):
    """Directions of upper arm and forearm that bring the wrist there, the elbow low and a little outside."""
    distance = math.sqrt(dot(hand_cm, hand_cm))
    along = unit(hand_cm)
    cosine = (UPPER_CM ** 2 + distance ** 2 - FOREARM_CM ** 2) / (2 * UPPER_CM * distance)
    assert abs(cosine) <= 1, "out of reach"
    low = (-0.4, -1.0, 0.0)
    aside = unit(tuple(l - dot(low, along) * a for l, a in zip(low, along)))
    sine = math.sqrt(1 - cosine * cosine)
    upper = tuple(cosine * a + sine * s for a, s in zip(along, aside))
    return upper, unit(tuple(h - UPPER_CM * u for h, u in zip(hand_cm, upper)))


def directions(t, shape):
    end = APPROACH_S + ROUNDS * ROUND_S
    x, y = shape(((t - APPROACH_S) / ROUND_S) % 1.0) if APPROACH_S < t < end else (0.0, 0.0)
    there = arm_to((MIDDLE_CM[0] + HALF_CM * x, MIDDLE_CM[1] + HALF_CM * y, MIDDLE_CM[2]))
    part = minimum_jerk(t / APPROACH_S) * minimum_jerk((end + APPROACH_S - t) / APPROACH_S)
    hanging = (unit((-0.1, -1.0, 0.0)), unit((-0.1, -1.0, 0.3)))
    return [unit(tuple(a + (b - a) * part for a, b in zip(rest, here))) for rest, here in zip(hanging, there)]


def frame(t, shape, names):
    upper, forearm = directions(t, shape)
    outwards = (-1.0, 0.0, 0.0)
    R_upper = rotation_to(outwards, upper)
    R_forearm = rotation_to(outwards, apply(transposed(R_upper), forearm))
    left = {"LeftArm": rotation_to((1.0, 0.0, 0.0), unit((0.1, -1.0, 0.0)))}
    turns = {"RightArm": R_upper, "RightForeArm": R_forearm, **left}
    values = list(ROOT_CM)
    for name in names:
        order = next(joint[3] for joint in JOINTS if joint[0] == name)
        values += euler_deg(turns[name], order) if name in turns else [0.0] * 3
    return " ".join(f"{value:.4f}" if abs(value) >= 5e-5 else "0" for value in values)


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).with_name("trajectories")
    folder.mkdir(exist_ok=True)
    tree = list(hierarchy("Hips"))
    names = [line.split()[1] for line in tree if line.split()[0] in ("ROOT", "JOINT")]
    count = round(FRAME_RATE_HZ * (2 * APPROACH_S + ROUNDS * ROUND_S)) + 1
    for name, shape in SHAPES.items():
        lines = ["HIERARCHY"] + tree + ["MOTION", f"Frames: {count}", f"Frame Time: {1 / FRAME_RATE_HZ:.9f}"]
        lines += [frame(i / FRAME_RATE_HZ, shape, names) for i in range(count)]
        (folder / f"{name}.bvh").write_text("\n".join(lines) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
