# SPDX-License-Identifier: Apache-2.0
"""Robots: kinematics against the golden file, cold inverse kinematics by TRAC-IK's protocol, following within the targets,
limits on real motion judged from the commands alone, the paper's six trajectories on Robonaut 2 with a robot that lags,
the live chain from a suit to a robot, and every fault of the robot's control port."""
import contextlib
import csv
import json
import math
import re
import signal
import subprocess
import xml.etree.ElementTree as ElementTree

import built_tests
import live
import studio

ROBOTS = studio.ROOT.parent / "shared" / "data" / "robots"
TRAJECTORIES = studio.ROOT / "resources" / "motions" / "trajectories"
SIX = "vertical", "horizontal", "diagonal", "circle", "box", "infinity"
MODELS = {"Panda": "panda/panda.urdf", "UR5": "ur5/ur5.urdf", "Baxter": "baxter/baxter.urdf",
          "Robonaut 2": "robonaut2/r2.urdf", "G1": "unitree_g1/g1_29dof_rev_1_0.urdf"}
FOLDER = studio.OUT / "robot"
REAL_MOTION_S = 600
SPEEDS = 1.0, 0.7, 0.85, 1.2  # of what was recorded: the recordings at hand last 171 s
NO_SPEED, USUAL_SPEED = 100, 2.5  # rad/s: a stated speed beyond the first is none, the second is taken
ROUNDING = 1e-6
MOST_MEDIAN_MS, MOST_P999_MS = 12, 25
LATENCY_MS = 60  # of the robot that draws the six


def limits_of(urdf):
    """Lower, upper and speed of each joint as the file states them; read apart from the program."""
    found = {}
    for joint in ElementTree.parse(urdf).getroot().iter("joint"):
        limit = joint.find("limit")
        if limit is None or joint.get("type") == "fixed":
            continue
        bounds = (-math.inf, math.inf) if joint.get("type") == "continuous" else (float(limit.get("lower", 0)),
                                                                                 float(limit.get("upper", 0)))
        speed = float(limit.get("velocity", "inf"))
        found[joint.get("name")] = (*bounds, USUAL_SPEED if speed > NO_SPEED else speed)
    return found


def broken_limits(table, limits):
    """Rows of the table, its seconds, the largest use of a speed limit, and how many values break a limit."""
    with open(table, newline="") as file:
        rows = list(csv.reader(file))
    names, values = rows[0][1:], [[float(value) for value in row] for row in rows[1:]]
    broken, largest = 0, 0.0
    for before, now in zip([None, *values], values):
        for i, name in enumerate(names, start=1):
            lower, upper, speed = limits[name]
            broken += not lower - 1e-8 <= now[i] <= upper + 1e-8
            if before:
                use = abs(now[i] - before[i]) / (now[0] - before[0]) / speed
                largest = max(largest, use)
                # The table's numbers are rounded to 1e-9.
                broken += use > 1 + ROUNDING + 2e-9 / (now[0] - before[0]) / speed
    return len(values), values[-1][0] if values else 0.0, largest, broken


def real_motions():
    return sorted(studio.MORE_MOTIONS.rglob("*.bvh")) + sorted(studio.REAL_MOTIONS.glob("[0-9]*.bvh"))


def at_speed(motion, speed):
    """The same motion with another time from frame to frame."""
    if speed == 1:
        return motion
    text = motion.read_text(errors="replace")
    frame_s = float(re.search(r"Frame Time:\s*([\d.]+)", text).group(1))
    made = FOLDER / "at_speed.bvh"
    made.write_text(re.sub(r"Frame Time:\s*[\d.]+", f"Frame Time: {frame_s / speed:.8f}", text, count=1))
    return made


def limits_on_real_motion():
    rows, missed = [], []
    for name, file in MODELS.items():
        limits, seconds, frames, broken, largest = limits_of(ROBOTS / file), 0.0, 0, 0, 0.0
        table = FOLDER / "commands.csv"
        for speed, motion in ((speed, motion) for speed in SPEEDS for motion in real_motions()):
            if seconds >= REAL_MOTION_S:
                break
            studio.batch("robot", at_speed(motion, speed), "--robot", ROBOTS / file, "--out", table, "--overwrite")
            count, lasts, use, wrong = broken_limits(table, limits)
            frames, seconds, broken, largest = frames + count, seconds + lasts, broken + wrong, max(largest, use)
        rows.append([name, f"{seconds:.0f}", frames, f"{largest:.4f}", broken])
        if broken:
            missed.append(f"{name}: {broken} values break a limit")
        if seconds < REAL_MOTION_S:
            missed.append(f"{name}: {seconds:.0f} s of motion, {REAL_MOTION_S} wanted")
    about = ("Every recording as it was made (171 s), then 0.7, 0.85 and 1.2 times as fast, until ten minutes are over.\n\n")
    return about + studio.markdown_table(["robot", "seconds of motion", "commands", "largest share of a speed limit",
                                  "values beyond a limit"], rows), missed


@contextlib.contextmanager
def virtual_robot(urdf, interface, *options):
    """Its address."""
    process = subprocess.Popen([studio.BUILD / "noctule-virtual-robot", "--robot", urdf, interface, "127.0.0.1:0",
                                *map(str, options)], stdout=subprocess.PIPE, text=True)
    try:
        yield process.stdout.readline().split("robot: ")[1].strip()
    finally:
        process.send_signal(signal.SIGINT)
        process.wait()


def drive(*arguments):
    return json.loads(studio.batch("drive", *arguments, "--json"))


def six_trajectories():
    """With the paper's two inertial sensors on the arm, and with the whole suit."""
    urdf, rows, missed = ROBOTS / MODELS["Robonaut 2"], [], []
    for name in SIX:
        take = FOLDER / f"{name}.noctule"
        studio.simulate(TRAJECTORIES / f"{name}.bvh", take)
        for run, sensors in (("inertia", "AG"), ("whole suit", "AGD")):
            studio.process(take, sensors, run)
            report = FOLDER / f"{name}_{run.replace(' ', '_')}.html"
            with virtual_robot(urdf, "--udp", "--arms", "right", "--latency-ms", LATENCY_MS) as address:
                said = drive(take, "--run", run, "--robot", urdf, "--arms", "right", "--to", address, "--hold",
                             "--accept-within", 180, "--report", report, "--overwrite")
            tracking = said["hands"][0]["tracking"]
            if not tracking:
                missed.append(f"{name}, {run}: the hand did not move")
                continue
            rows.append([name, run, said["commands_following"], *(f"{tracking[key]:.1f}" for key in
                                                                  ("delay_ms", "apart_rms_mm", "rest_rms_mm", "rest_max_mm"))])
    return (f"Robonaut 2's right arm over UDP, a robot that hears {LATENCY_MS} ms late and lags 20 ms. Drawings in "
            f"three views as in figure 9: `{FOLDER.relative_to(studio.ROOT)}/*.html`.\n\n" +
            studio.markdown_table(["trajectory", "sensors", "commands while following", "delay, ms",
                                   "apart at one instant, rms mm", "rest after the delay, rms mm", "largest, mm"], rows)), missed


def live_chain(seconds):
    """Virtual suit, studio's processing, virtual robot as rosbridge."""
    take, calibration = live.worn_take(min(seconds, 40) + 10)
    urdf = ROBOTS / MODELS["G1"]
    suit = subprocess.Popen([studio.BUILD / "noctule-virtual-suit", "--take", take, "--tcp", "127.0.0.1:0", "--loop"],
                            stdout=subprocess.PIPE, text=True)
    try:
        device = next(word for line in suit.stdout for word in line.split() if word.startswith("tcp://"))
        with virtual_robot(urdf, "--rosbridge") as address:
            said = drive("--device", device, "--calibration", calibration, "--robot", urdf, "--to", address, "--hold",
                         "--accept-within", 180, "--seconds", seconds)
    finally:
        suit.send_signal(signal.SIGINT)
        suit.wait()
    latency = said["latency"]
    missed = [f"{what} {latency[key]:.1f} ms, limit {limit}" for what, key, limit in
              (("median", "median_ms", MOST_MEDIAN_MS), ("99.9 %", "p999_ms", MOST_P999_MS)) if latency[key] > limit]
    if said["largest_speed_use"] > 1 + 1e-9:
        missed.append("a command was faster than its limit")
    return (f"G1, both arms, {seconds} s; from the arrival of data to the command written.\n\n" +
            studio.markdown_table(["commands", "while following", "median, ms", "99.9 %, ms", "worst, ms", "steps skipped",
                                   "largest share of a speed limit"],
                                  [[said["commands"], said["commands_following"], f"{latency['median_ms']:.2f}",
                                    f"{latency['p999_ms']:.2f}", f"{latency['worst_ms']:.2f}", said["steps_skipped"],
                                    f"{said['largest_speed_use']:.4f}"]])), missed


def programs_of_ros():
    """What `rostopic echo` hears of a drive through noctule-ros-bridge."""
    bridge = studio.BUILD / "noctule-ros-bridge"
    if not bridge.exists():
        return "roscpp is not installed.", ["no bridge to ROS was built"]
    ran = subprocess.run([studio.ROOT / "tests" / "ros_bridge.py", studio.BUILD / "noctule", bridge, "--rate"],
                         capture_output=True, text=True, check=False)
    return (f"- {ran.stdout.strip()}\n", []) if ran.returncode == 0 else (ran.stderr, ["the bridge to ROS failed"])


def figure(options):
    if not ROBOTS.exists():
        raise RuntimeError(f"{ROBOTS} is needed: URDFs of real robots")
    FOLDER.mkdir(parents=True, exist_ok=True)
    parts, missed = [], []

    def add(title, made):
        text, reasons = made if isinstance(made, tuple) else (made, [])
        parts.append(f"### {title}\n\n{text}\n")
        missed.extend(reasons)

    def built(program, cases, wanted):
        try:
            return built_tests.run(program, cases, wanted)
        except studio.Missed as error:
            return error.text, [str(error)]

    add("Forward kinematics: the golden file to 1e-9", built("test_core_robot", "RobotKinematics.AgreesWithTheGoldenFile",
                                                            r"OK \] Robot"))
    add("Cold inverse kinematics: 1e-5 from the middle posture",
        built("test_core_robot", "RobotKinematics.FindsAPosture*", r" of \d+, [\d.]+ iterations"))
    add("Following: upper arm and forearm in degrees, wrist in mm", built("test_core_robot", "RobotMapping.*", r" deg .* mm"))
    add("Limits on real motion, from the commands alone", limits_on_real_motion())
    add("Six trajectories", six_trajectories())
    add("Live chain", live_chain(options.robot_seconds))
    add("Two programs of ROS 1", programs_of_ros())
    add("Kinematics and Jacobians beside Orocos KDL", built("test_core_robot_kdl", "*", r"OK \] Robots"))
    add("Faults of the robot's control port, over both interfaces",
        built("test_app_virtual_robot", "Robot/EveryInterface.*", r"OK \] Robot"))
    text = "\n".join(parts)
    if missed:
        raise studio.Missed(missed, text)
    return text
