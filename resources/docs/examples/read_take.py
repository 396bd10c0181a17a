# SPDX-License-Identifier: Apache-2.0
# python3 read_take.py TAKE.noctule [JOINT]: poses of the newest result; Python alone is enough.
import json
import sqlite3
import struct
import sys

take = sqlite3.connect(f"file:{sys.argv[1]}?mode=ro", uri=True)
joints = [joint["name"] for joint in json.loads(take.execute("SELECT json FROM actor ORDER BY id DESC").fetchone()[0])["joints"]]
run = take.execute("SELECT max(run) FROM derived WHERE kind = 'pose'").fetchone()[0]
joint = joints.index(sys.argv[2] if len(sys.argv) > 2 else joints[-1])
for time_ns, x, y, z, blob in take.execute("SELECT time_ns, px, py, pz, q FROM pose WHERE run = ? ORDER BY time_ns", (run,)):
    w, i, j, k = struct.unpack(f"<{4 * len(joints)}d", blob)[4 * joint:4 * joint + 4]
    print(f"{time_ns / 1e9:.4f} {x:.4f} {y:.4f} {z:.4f} {w:.6f} {i:.6f} {j:.6f} {k:.6f}")
