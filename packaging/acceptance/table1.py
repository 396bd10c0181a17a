# SPDX-License-Identifier: Apache-2.0
"""Table 1 of Vlasic 2007 on several real motions: every combination of sensors, both estimators.

Run with the output of `evaluate --json` as its argument it prints that run's row beside the paper's.
"""
import concurrent.futures
import json
import math
import pathlib
import re
import sys

import studio

PAPER_FILE = studio.ROOT / "core" / "report" / "paper_table.h"
JOINTS = ("Head", "RightArm", "LeftUpLeg")  # the paper's neck, right shoulder and left hip
PAPER_SIGMA = 0.04
SIGMAS_TO_TRY = (0.4, 1, 3, 10)


def paper_rows():
    """{"AGD": [(5.7, 2.9), (8.0, 5.0), (6.6, 3.8)], ...} in the paper's order."""
    text = PAPER_FILE.read_text()
    numbers = r"\{([\d., ]+)\}"
    rows = {}
    for sensors, means, deviations in re.findall(r'\{"([AGD]+)", ' + numbers + ", " + numbers, text):
        rows[sensors] = list(zip(map(float, means.split(",")), map(float, deviations.split(","))))
    assert len(rows) == 7, f"{PAPER_FILE} does not hold the seven rows of the paper's table"
    return rows


def joint_angles(evaluation):
    by_name = {joint["name"]: joint for joint in evaluation["joints"]}
    return [(by_name[name]["mean_deg"], by_name[name]["std_deg"]) for name in JOINTS]


def cell(angles, digits=1):
    return " / ".join(" ± ".join(studio.number(value, digits) for value in pair) for pair in angles)


def row_beside_the_paper(evaluation):
    sensors = evaluation["sensors"]
    paper = paper_rows()[sensors]
    angles = joint_angles(evaluation)
    lines = [f"Table 1, {'+'.join(sensors)}: angle to the reference in degrees, mean ± deviation",
             f"{'':14}{'neck (Head)':>18}{'right shoulder':>18}{'left hip':>18}"]
    for name, values, digits in (("paper", paper, 1), ("this run", angles, 2)):
        lines.append(f"{name:14}" + "".join(f"{cell([pair], digits):>18}" for pair in values))
    lines.append(f"mean over all joints: {studio.number(evaluation['mean_deg'])} degrees")
    return "\n".join(lines)


def motions():
    found = [studio.REAL_MOTIONS / f"{name}.bvh" for name in ("Boxing_Toes", "01_01", "01_03")]
    found += [studio.MORE_MOTIONS / f"{name}.bvh" for name in ("02_01", "05_06")]
    return [path for path in found if path.exists()]


class Runs:
    """The evaluations of one take's runs, each processed when it is first asked for."""

    def __init__(self, take):
        self.take = take
        self.evaluations = {}

    def get(self, sensors, estimator, sigma=None):
        key = (sensors, estimator, sigma)
        if key not in self.evaluations:
            name = f"{sensors}-{estimator}" + (f"-{sigma:g}" if sigma else "")
            options = ("--paper-sigma", sigma) if sigma else ()
            studio.process(self.take, sensors, name, "--estimator", estimator, *options)
            self.evaluations[key] = studio.evaluate(self.take, name)
        return self.evaluations[key]

    def best_sigma(self, candidates):
        """The one with which the paper's estimator and all its sensors do best on this motion."""
        return min(candidates, key=lambda sigma: error(self.get("AGD", "paper", sigma)))


def error(evaluation):
    """For comparing: no result is the worst of all."""
    return math.inf if evaluation["mean_deg"] is None else evaluation["mean_deg"]


def inversions(results):
    """Pairs in the paper's order of which the later is worse here; results: [(sensors, evaluation)]."""
    found = []
    for i, (earlier, first) in enumerate(results):
        for later, second in results[i + 1:]:
            if error(second) > error(first):
                found.append(f"{'+'.join(later)} ({error(second):.2f}) after {'+'.join(earlier)} ({error(first):.2f})")
    return "; ".join(found) or "none"


def figure_of_motion(motion, paper_sigma):
    take = studio.OUT / "table1" / f"{motion.stem}_001.noctule"
    studio.simulate(motion, take, "--level", "signal")
    runs = Runs(take)
    sigma = paper_sigma or runs.best_sigma(SIGMAS_TO_TRY)
    columns = [("manifold", "manifold", None), (f"paper, sigma {PAPER_SIGMA}", "paper", PAPER_SIGMA),
               (f"paper, sigma {sigma:g}", "paper", sigma)]

    head = ["sensors", "Vlasic 2007"] + [title for name, *_ in columns for title in (name, f"{name}: all joints")]
    rows = []
    for sensors, paper in paper_rows().items():
        row = ["+".join(sensors), cell(paper)]
        for _, *variant in columns:
            evaluation = runs.get(sensors, *variant)
            row += [cell(joint_angles(evaluation)), studio.number(evaluation["mean_deg"])]
        rows.append(row)
    studio.evaluate(take, "AGD-manifold", "--report", take.with_suffix(".html"), "--overwrite")
    text = f"### {motion.stem}, {studio.take_seconds(take):.0f} s\n\n" + studio.markdown_table(head, rows) + "\n"
    for name, *variant in columns:
        results = [(sensors, runs.get(sensors, *variant)) for sensors in paper_rows()]
        text += f"- Against the paper's order, {name}: {inversions(results)}\n"
    return text + "\n"


def figure(options):
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        parts = list(pool.map(lambda motion: figure_of_motion(motion, options.paper_sigma), motions()))
    return ("Scenario nominal, level signal, root given. Degrees, mean ± deviation of Head / RightArm / LeftUpLeg "
            "(the paper's neck, right shoulder, left hip); \"all joints\" is the mean over all joints. The paper's "
            f"estimator is shown with its own process sigma of {PAPER_SIGMA} and with the one that serves it best "
            "on the motion.\n\n" + "".join(parts))


if __name__ == "__main__":
    print(row_beside_the_paper(json.loads(pathlib.Path(sys.argv[1]).read_text())))
