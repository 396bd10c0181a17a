# SPDX-License-Identifier: Apache-2.0
"""Suits with boards left out, on real motions: what the boards that remain tell of segments that carry none."""
import json

import accuracy
import studio

SECONDS = 20
SEED = 3
LEFT_OUT = {"nothing": (), "Chest": ("Chest",), "Spine, Chest": ("Spine", "Chest"),
            "upper arms": ("LeftArm", "RightArm"), "thighs": ("LeftUpLeg", "RightUpLeg"),
            "shoulders": ("LeftShoulder", "RightShoulder"), "shanks": ("LeftLeg", "RightLeg")}
NAMES = ("walk", "boxer", "hops and turn", "01_03")


def suit_without(segments, path):
    suit = json.loads((studio.ROOT / "resources" / "suits" / "default.json").read_text())
    suit["boards"] = [board for board in suit["boards"] if board["segment"] not in segments]
    path.write_text(json.dumps(suit))
    return path


def cell(folder, scenario, motion, suit):
    take, worn = folder / "worn.noctule", folder / "worn.json"
    studio.batch("simulate", "--motion", motion, "--suit", suit, "--scenario", scenario, "--seed", SEED,
                 "--level", "readings", "--duration", SECONDS, "--out", take, "--overwrite")
    options = ()
    if scenario == "realistic":
        studio.batch("calibrate", "rest-pose", take, "--out", worn, "--overwrite")
        options = ("--calibration", worn)
    studio.process(take, "AGD", "AGD", *options)
    evaluation = studio.evaluate(take, "AGD")
    return f"{studio.number(evaluation['mean_deg'])} ({studio.number(evaluation['nees'], 1)})"


def figure(_):
    folder = studio.OUT / "partial"
    folder.mkdir(parents=True, exist_ok=True)
    motions = [name for name in NAMES if accuracy.MOTIONS[name].exists()]
    text = (f"Mean angle over all joints in degrees (NEES), A+G+D, root given, filtered, {SECONDS} s, readings level, "
            f"seed {SEED}; realistic after `calibrate rest-pose` on the take itself.\n")
    for scenario in ("nominal", "realistic"):
        rows = []
        for name, segments in LEFT_OUT.items():
            suit = suit_without(segments, folder / "suit.json")
            rows.append([name, *(cell(folder, scenario, accuracy.MOTIONS[motion], suit) for motion in motions)])
        text += f"\n### {scenario.capitalize()}\n\n" + studio.markdown_table(["boards left out", *motions], rows)
    return text
