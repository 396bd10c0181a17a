# SPDX-License-Identifier: Apache-2.0
"""Calibration on simulated rigs, many suits of 18 boards, from rendered photographs and from a guided movement; true
values hidden."""
import built_tests
import screen
import studio

MOTIONS = (studio.REAL_MOTIONS / "01_01.bvh", studio.REAL_MOTIONS / "Boxing_Toes.bvh", studio.REAL_MOTIONS / "01_03.bvh")
MOVED = ("--scenario", "realistic", "--level", "readings", "--seed", 1)


def guided_calibrations(folder):
    """(calibration, actor) of the rest pose alone and of the guided movement, of one suit on one performer."""
    folder.mkdir(parents=True, exist_ok=True)
    guided, take = folder / "guided.bvh", folder / "guided_001.noctule"
    built_tests.run("test_core_calibration", "GuidedMovementFile.IsWrittenAsAFile", "guided", NOCTULE_GUIDED_BVH=str(guided))
    studio.batch("simulate", "--motion", guided, "--out", take, *MOVED, "--overwrite")
    with studio.open_take(take) as database:
        (folder / "actor.json").write_text(database.execute("SELECT json FROM actor").fetchone()[0])
    rest, moved = folder / "rest.json", folder / "moved.json"
    studio.batch("calibrate", "rest-pose", take, "--out", rest, "--overwrite")
    studio.batch("calibrate", "motion", take, "--base", rest, "--out", moved, "--actor-out", folder / "performer.json",
                 "--report", folder / "moved.html", "--overwrite")
    return (rest, folder / "actor.json"), (moved, folder / "performer.json")


def angle_error(folder, motion, name, calibration, actor, *options):
    """Mean over the joints, all sensors, of a motion that was not used for calibrating."""
    take = folder / f"{motion.stem}_001.noctule"
    if not take.exists():
        studio.batch("simulate", "--motion", motion, "--out", take, *MOVED, "--actor", folder / "actor.json")
    studio.process(take, "AGD", name, "--calibration", calibration, "--actor", actor, *options)
    return studio.evaluate(take, name)["mean_deg"]


def movement():
    folder = studio.OUT / "movement"
    for old in folder.glob("*_001.noctule"):
        old.unlink()
    rest, moved = guided_calibrations(folder)
    rows, missed = [], []
    for motion in filter(lambda path: path.exists(), MOTIONS):
        before, after = (angle_error(folder, motion, name, *values)
                         for name, values in (("rest", rest), ("moved", moved)))
        smoothed = angle_error(folder, motion, "smoothed", *moved, "--smooth", "full")
        rows.append([motion.stem, *map(studio.number, (before, after, smoothed, after / before))])
        if after > before / 2:
            missed.append(f"{motion.stem}: {after / before:.2f} of the error with the rest pose alone, not half")
    text = studio.markdown_table(["motion", "rest pose alone, deg", "guided movement, deg", "smoothed, deg",
                                  "share, not smoothed"], rows)
    if missed:
        raise studio.Missed(missed, text)
    return text


def at_an_operators_pace():
    with screen.own_screen() as display, screen.own_home(display, NOCTULE_WIZARD_PACE="1") as environment:
        return built_tests.run("test_ui_wizards", "*OperatorsPace", "18 boards", environment)


def figure(options):
    trials = str(options.calibration_trials)
    parts = [("Rigs, rest pose and movement",
              lambda: built_tests.run("test_core_calibration", "*", r"[0-9].*(mm|mg|deg|°|named|error)",
                                      NOCTULE_CALIBRATION_TRIALS=trials)),
             ("Photographs with markers", lambda: built_tests.run("test_core_vision", "*", r"(mm|px|chi-square)")),
             ("The wizards of accelerometers and gyroscopes with an operator", at_an_operators_pace),
             ("What a guided movement does for other motions", movement)]
    text = f"Nominal scenario, {trials} suits each; movement in the realistic one, a tenth as many performers.\n\n"
    missed = []
    for title, part in parts:
        try:
            found = part()
        except studio.Missed as error:
            missed.append(str(error))
            found = error.text
        text += f"### {title}\n\n{found}\n"
    if missed:
        raise studio.Missed(missed, text)
    return text
