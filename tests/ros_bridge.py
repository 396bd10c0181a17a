#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""ros_bridge.py NOCTULE BRIDGE: a drive over UDP, through the bridge, to programs of ROS on a master of its own.
`rostopic pub` is the robot's state, `rostopic echo` hears the commands. Every command heard must be one that the drive
wrote, and the state that the drive saw must be the one published. `--rate` prints how many commands came a second."""
import csv
import json
import os
import pathlib
import signal
import socket
import sqlite3
import shutil
import subprocess
import sys
import tempfile
import time

TINY = pathlib.Path(__file__).resolve().parent / "data/takes/tiny_take.noctule"
JOINTS = ["s0", "s1", "s2", "e", "f", "w0", "w1"]
STATE = [0.1, -0.2, 0.3, -1.4, 0.5, -0.6, 0.7]
SECONDS = 3


def urdf():
    places = ["0 -0.2 1.4", "0 0 0", "0 0 0", "0 0 -0.3", "0 0 -0.1", "0 0 -0.2", "0 0 0"]
    axes = ["0 1 0", "1 0 0", "0 0 1", "0 1 0", "0 0 1", "0 1 0", "1 0 0"]
    text = '<robot name="arm"><link name="l0"/>'
    for i, (joint, place, axis) in enumerate(zip(JOINTS, places, axes)):
        text += (f'<link name="l{i + 1}"/><joint name="{joint}" type="revolute"><parent link="l{i}"/>'
                 f'<child link="l{i + 1}"/><axis xyz="{axis}"/><origin xyz="{place}"/>'
                 f'<limit lower="-2.5" upper="2.5" velocity="2" effort="1"/></joint>')
    return text + "</robot>"


def profile():
    return {"format": "noctule robot profile", "version": 1, "robot": "arm", "clearance_m": 0,
            "weights": {}, "arms": [
                {"name": "right", "side": "right", "base": "l0", "tip": "l7", "shoulder_joint": "s0",
                 "elbow_joint": "e", "wrist_joint": "w0", "left_axis": [0, 1, 0], "up_axis": [0, 0, 1],
                 "reference_rad": [0, 0, 0, -1.5, 0, 0, 0], "max_speed_rad_per_s": [2] * 7}]}


def take_with_poses(path):
    """The small take; what its simulation says of the truth becomes result 1."""
    shutil.copy(TINY, path)
    with sqlite3.connect(path) as take:
        take.executescript("""
            CREATE TABLE derived (run INTEGER PRIMARY KEY, kind TEXT, name TEXT);
            CREATE TABLE pose (run INTEGER, time_ns INTEGER, px REAL, py REAL, pz REAL, q BLOB);
            INSERT INTO derived VALUES (1, 'pose', 'test');
            INSERT INTO pose SELECT 1, time_ns, px, py, pz, q FROM reference;""")


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Programs:
    """All end with the test, also when it fails."""

    def __init__(self, environment):
        self.environment, self.running = environment, []

    def start(self, *command, **options):
        self.running.append(subprocess.Popen(command, env=self.environment, text=True, **options))
        return self.running[-1]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for program in reversed(self.running):
            program.send_signal(signal.SIGINT)
        for program in self.running:
            try:
                program.wait(10)
            except subprocess.TimeoutExpired:
                program.kill()


def until(what, condition):
    for _ in range(600):
        if condition():
            return
        time.sleep(0.1)
    sys.exit(f"ros_bridge: waited a minute for {what}")


def ask(environment, *command):
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


def listen(programs, folder, bridge, environment):
    robot, made = folder / "arm.urdf", folder / "arm.json"
    robot.write_text(urdf())
    made.write_text(json.dumps(profile()))
    programs.start("rostopic", "pub", "-r", "100", "/joint_states", "sensor_msgs/JointState",
                   json.dumps({"name": JOINTS, "position": STATE}), stdout=subprocess.DEVNULL)
    carrier = programs.start(bridge, "--robot", robot, "--profile", made, "--udp", "127.0.0.1:0",
                             stdout=subprocess.PIPE)
    address = carrier.stdout.readline().split()[-1]
    heard = folder / "heard.csv"
    programs.start("rostopic", "echo", "-p", "/noctule/joint_command", stdout=heard.open("w"))
    until("rostopic to listen",
          lambda: "/rostopic" in ask(environment, "rostopic", "info", "/noctule/joint_command").stdout)
    return robot, made, address, heard


def rows_of(path):
    with path.open() as file:
        return [row for row in csv.DictReader(file) if None not in row.values()]


def compare(heard, written, seconds, wants_rate):
    positions = [tuple(float(row[f"field.position{i}"]) for i in range(len(JOINTS))) for row in rows_of(heard)]
    rows = rows_of(written)
    sent = {tuple(round(float(row[f"command {joint}"]), 6) for joint in JOINTS) for row in rows}
    strangers = [one for one in positions if tuple(round(value, 6) for value in one) not in sent]
    if len(positions) < 50 or strangers:
        sys.exit(f"ros_bridge: {len(positions)} commands heard, {len(strangers)} of them never sent: {strangers[:1]}")
    seen = [[float(row[f"actual {joint}"]) for joint in JOINTS] for row in rows if row[f"actual {JOINTS[0]}"]]
    if not seen or any(abs(a - b) > 1e-6 for row in seen for a, b in zip(row, STATE)):
        sys.exit(f"ros_bridge: the robot's state came back as {seen[:1]} instead of {STATE}")
    print(f"{len(positions)} of {len(rows)} commands heard by rostopic, all as they were sent"
          + (f", {len(positions) / seconds:.1f} a second" if wants_rate else ""))


def main():
    if len(sys.argv) < 3 or not shutil.which("rosmaster") or not shutil.which("rostopic"):
        sys.exit(__doc__)
    noctule, bridge = sys.argv[1:3]
    port = free_port()
    environment = dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1")
    silent = ask(environment, bridge, "--robot", "/nowhere.urdf")
    if silent.returncode != 3 or "/nowhere.urdf" not in silent.stderr:
        sys.exit(f"ros_bridge: a URDF that is not there gave {silent.returncode}: {silent.stderr}")
    with tempfile.TemporaryDirectory() as name, Programs(environment) as programs:
        folder = pathlib.Path(name)
        environment["ROS_LOG_DIR"] = environment["ROS_HOME"] = name
        programs.start("rosmaster", "--core", "-p", str(port), stdout=subprocess.DEVNULL)
        until("the master", lambda: ask(environment, "rostopic", "list").returncode == 0)
        robot, made, address, heard = listen(programs, folder, bridge, environment)
        take, written = folder / "t.noctule", folder / "drive.csv"
        take_with_poses(take)
        drive = subprocess.run([noctule, "--batch", "drive", take, "--robot", robot, "--profile", made, "--to", address,
                                "--arms", "right", "--repeat", "--seconds", str(SECONDS), "--out", written, "--quiet"],
                               input="", capture_output=True, text=True, check=False)
        if drive.returncode:
            sys.exit(f"ros_bridge: drive ended with {drive.returncode}: {drive.stderr}")
        time.sleep(0.5)
        compare(heard, written, SECONDS, "--rate" in sys.argv)


if __name__ == "__main__":
    main()
