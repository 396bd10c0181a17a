# SPDX-License-Identifier: Apache-2.0
"""What could be reached at best, and from how far off: as the measuring programs print it."""
import subprocess

import accuracy
import calibration
import studio


def measured(program, *arguments):
    command = [str(studio.BUILD / f"measure_{program}"), *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout.strip()


def existing(*names):
    return [accuracy.MOTIONS[name] for name in names if accuracy.MOTIONS[name].exists()]


def figure(_):
    folder = studio.OUT / "bounds"
    _, (moved, performer) = calibration.guided_calibrations(folder)
    bounds = [measured("bounds", motion) for motion in existing("boxer", "walk")]
    floors = [measured("floor", moved, performer, folder / "actor.json", motion)
              for motion in existing("walk", "boxer", "hops and turn", "01_03")]
    return "\n\n".join([
        "### Posterior Cramer-Rao bounds, nominal\n\nIn brackets: times the bound. Drawn: on measurements drawn as the "
        "bound assumes them; rigid: joint laxity is not estimated.", *bounds,
        "### People: exact attitudes of all boards, root given\n\nConstant: each board as it is turned in the mean over "
        "the take; calibrated: as the guided movement has told.", *floors,
        f"### Wrong starts\n\n{measured('starts')}"])
