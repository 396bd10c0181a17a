# SPDX-License-Identifier: Apache-2.0
# python3 read_take.py TAKE.noctule [JOINT [SUIT]]: poses of the newest result, of suit 1; Python alone is enough.
import json
import sqlite3
import struct
import sys

take = sqlite3.connect(f"file:{sys.argv[1]}?mode=ro", uri=True)
suit = int(sys.argv[3]) if len(sys.argv) > 3 else 1


def of_suit(table):  # takes of one suit may lack the column
    has_suit = "suit" in [column[1] for column in take.execute(f"PRAGMA table_info({table})")]
    return f"suit = {suit}" if has_suit else str(int(suit == 1))


actor = take.execute(f"SELECT json FROM actor WHERE {of_suit('actor')} ORDER BY id DESC").fetchone()
if actor is None:
    sys.exit(f"{sys.argv[1]}: nobody wears suit {suit}; name another one after the joint")
joints = [joint["name"] for joint in json.loads(actor[0])["joints"]]
joint = joints.index(sys.argv[2] if len(sys.argv) > 2 else joints[-1])
for time_ns, x, y, z, blob in take.execute(f"""SELECT time_ns, px, py, pz, q FROM pose WHERE {of_suit('pose')} AND
        run = (SELECT max(run) FROM pose WHERE {of_suit('pose')}) ORDER BY time_ns"""):
    w, i, j, k = struct.unpack(f"<{4 * len(joints)}d", blob)[4 * joint:4 * joint + 4]
    print(f"{time_ns / 1e9:.4f} {x:.4f} {y:.4f} {z:.4f} {w:.6f} {i:.6f} {j:.6f} {k:.6f}")
