# SPDX-License-Identifier: Apache-2.0
"""A writer of takes that knows the take format only: two performers and the anchors of a room, at level readings.

The room is suit 1, so that its clock is take time; the performers wear suits 7 and 3, in this order in the file. Boards
and sources differ in number, boxes in sampling rate, carrier and interval, boards in their rate. Only the tables with
rows are made. Plain Python: vectors are lists, quaternions w, x, y, z.
"""
import json
import math
import random
import sqlite3
import struct

C_M_PER_S = 345.0
G = 9.80665
REST_S = 2.0
ROOM, ANNA, BORIS = 1, 7, 3
OFFSET_S = 1.1e-4  # of every source, for the detector that the takes name
MIC_DELAY_S = 2e-6


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def scaled(a, s):
    return [x * s for x in a]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def norm(a):
    return math.sqrt(dot(a, a))


def times(p, q):
    return [p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
            p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def turn(q, v):
    t = scaled(cross(q[1:], v), 2)
    return add(add(v, scaled(t, q[0])), cross(q[1:], t))


def exp(w):
    angle = norm(w)
    s = 0.5 if angle < 1e-12 else math.sin(angle / 2) / angle
    return [math.cos(angle / 2), w[0] * s, w[1] * s, w[2] * s]


def log(q):
    if q[0] < 0:
        q = scaled(q, -1)
    s = norm(q[1:])
    return scaled(q[1:], 2 * math.atan2(s, q[0]) / s) if s > 1e-15 else scaled(q[1:], 2)


JOINTS = [("Hips", -1, (0, 0, 0)), ("Spine", 0, (0, 0.1, 0)), ("Chest", 1, (0, 0.2, 0)), ("Head", 2, (0, 0.3, 0)),
          ("LeftArm", 2, (0.18, 0.2, 0)), ("LeftForeArm", 4, (0.28, 0, 0)), ("LeftHand", 5, (0.25, 0, 0)),
          ("RightArm", 2, (-0.18, 0.2, 0)), ("RightForeArm", 7, (-0.28, 0, 0)), ("RightHand", 8, (-0.25, 0, 0)),
          ("LeftUpLeg", 0, (0.09, -0.05, 0)), ("LeftLeg", 10, (0, -0.42, 0)), ("LeftFoot", 11, (0, -0.42, 0)),
          ("RightUpLeg", 0, (-0.09, -0.05, 0)), ("RightLeg", 13, (0, -0.42, 0)), ("RightFoot", 14, (0, -0.42, 0))]
INDEX = {name: i for i, (name, _, _) in enumerate(JOINTS)}
HIPS_M = 0.92


def actor(name, size):
    joints = []
    for joint, parent, offset in JOINTS:
        entry = {"name": joint, "parent": parent, "offset_m": scaled(offset, size)}
        if parent < 0:
            entry |= {"free": True, "dof": []}
        else:
            entry |= {"ball": True, "dof": [{"name": joint + axis, "axis": unit, "min_rad": -2.6, "max_rad": 2.6}
                                            for axis, unit in zip("XYZ", ([1, 0, 0], [0, 1, 0], [0, 0, 1]))]}
        joints.append(entry)
    return {"format": "noctule-actor", "version": 1, "name": name, "height_m": 1.72 * size, "joints": joints,
            "rest": {"q": [[1, 0, 0, 0]] * len(JOINTS)}}


class Body:
    """Holds the rest pose, then sways on its feet and swings its arms."""

    def __init__(self, size, place, heading, phase):
        self.size, self.place, self.heading, self.phase = size, place, heading, phase

    def ease(self, t):
        x = min(max((t - REST_S) / 1.5, 0.0), 1.0)
        return x * x * x * (10 - 15 * x + 6 * x * x)

    def pose(self, t):
        s, p = self.ease(t), self.phase
        local = [[1.0, 0.0, 0.0, 0.0] for _ in JOINTS]

        def bend(name, x, y, z):
            local[INDEX[name]] = exp([s * x, s * y, s * z])

        bend("Spine", 0.1 * math.sin(1.1 * t + p), 0.15 * math.sin(0.9 * t), 0.05 * math.sin(1.3 * t))
        bend("Head", 0.1 * math.sin(1.7 * t), 0.3 * math.sin(0.8 * t + p), 0)
        bend("LeftArm", 0.3 * math.sin(1.9 * t), 0.4 * math.sin(1.3 * t + p), -0.5 + 0.3 * math.sin(1.5 * t))
        bend("LeftForeArm", 0, -0.5 + 0.4 * math.sin(2.1 * t + p), 0)
        bend("RightArm", 0.3 * math.sin(1.6 * t + p), 0.4 * math.sin(1.2 * t), 0.5 + 0.3 * math.sin(1.4 * t))
        bend("RightForeArm", 0, 0.5 + 0.4 * math.sin(1.8 * t), 0)
        local[0] = exp([0, self.heading + 0.25 * s * math.sin(0.7 * t + p), 0])
        sway = [0.08 * s * math.sin(0.9 * t), 0.0, 0.06 * s * math.sin(1.1 * t + p)]
        root = add([self.place[0], HIPS_M * self.size, self.place[1]], turn(exp([0, self.heading, 0]), sway))
        return root, local

    def frames(self, t):
        """World place and rotation of each joint."""
        root, local = self.pose(t)
        frames = []
        for (_, parent, offset), q in zip(JOINTS, local):
            if parent < 0:
                frames.append((root, q))
            else:
                at, above = frames[parent]
                frames.append((add(at, turn(above, scaled(offset, self.size))), times(above, q)))
        return frames


class Suit:
    """One box: its boards and sources, its clock, and what it wrote. `worn`: (id, segment, place, rotation vector, has
    a source). An anchor has no segment; its place is that in the world."""

    def __init__(self, number, name, body, worn, rate_hz, carrier_hz, interval, board_hz, clock, guess):
        self.number, self.name, self.body, self.worn = number, name, body, worn
        self.rate_hz, self.carrier_hz, self.interval, self.board_hz = rate_hz, carrier_hz, interval, board_hz
        self.clock, self.guess = clock, guess  # (offset_s, rate)
        self.speakers = [i for i, part in enumerate(worn) if part[4]]

    def normal(self, part):
        return turn(exp(part[3]), [0, 0, 1])

    def json(self):
        boards, sources = [], []
        for part in self.worn:
            name, segment, place, rotation, speaks = part
            boards.append({"id": name, "segment": segment, "p_segment_board_m": place,
                           "q_segment_board": exp(rotation), "rate_hz": self.board_hz})
            if speaks:
                sources.append({"id": name + " source", "segment": segment,
                                "p_segment_source_m": add(place, turn(exp(rotation), [0.01, 0, 0])),
                                "normal_segment": self.normal(part), "board": name})
        return {"format": "noctule-suit", "version": 1, "name": self.name, "boards": boards, "sources": sources,
                "carrier_hz": self.carrier_hz, "pulse_interval_samples": self.interval, "pulse_cycles": 10,
                "sample_rate_hz": self.rate_hz}

    def calibration(self):
        axis = {"zero_counts": [2048, 2048, 2048]}
        gyro, accel = 17.5 / 2048, 156.9064 / 2048
        boards = [{"id": part[0], "mic_delay_s": MIC_DELAY_S,
                   "gyro": axis | {"matrix": [[gyro, 0, 0], [0, gyro, 0], [0, 0, gyro]]},
                   "accel": axis | {"matrix": [[accel, 0, 0], [0, accel, 0], [0, 0, accel]]}} for part in self.worn]
        sources = [{"id": self.worn[i][0] + " source", "offsets_s": {"inflection": OFFSET_S}} for i in self.speakers]
        return {"format": "noctule-calibration", "version": 1, "created_utc": "2026-05-04T10:00:00Z",
                "sound": {"model": "fixed", "c_m_per_s": C_M_PER_S}, "sources": sources, "boards": boards}

    def take_s(self, suit_s, clock=None):
        offset, rate = clock or self.clock
        return offset + rate * suit_s

    def suit_s(self, take_s):
        return (take_s - self.clock[0]) / self.clock[1]

    def board_at(self, frames, part):
        name, segment, place, rotation, _ = part
        if segment is None:
            return place, exp(rotation)
        at, q = frames[INDEX[segment]]
        return add(at, turn(q, place)), times(q, exp(rotation))


def cast():
    """The room's three anchors and a fourth that only hears; two performers face to face."""
    anna = Body(1.0, (0.1, -0.7), 0.05, 0.3)
    boris = Body(1.06, (-0.1, 0.75), math.pi - 0.1, 1.9)

    def towards(x, y, z):
        """The rotation vector that turns a board's z axis from its corner to the middle of the room."""
        want = scaled([-x, 1 - y, -z], 1 / norm([x, 1 - y, z]))
        axis = cross([0, 0, 1], want)
        return scaled(axis, math.acos(want[2]) / max(norm(axis), 1e-9))

    corners = [(2.0, 2.4, 2.1), (2.1, 0.6, -2.0), (-2.2, 2.2, -1.9), (-1.9, 1.2, 2.2)]
    anchors = [(f"corner {i}", None, list(p), towards(*p), i < 3) for i, p in enumerate(corners)]
    side = math.pi / 2
    on_anna = [("hips", "Hips", [0, 0.02, 0.12], [0, 0, 0], True), ("chest", "Chest", [0, 0.1, 0.12], [0.1, 0, 0], True),
               ("l arm", "LeftArm", [0.14, 0, 0.05], [0, 0, 0.2], False),
               ("l hand", "LeftForeArm", [0.22, 0.03, 0.02], [0, 0.1, 0], True),
               ("r arm", "RightArm", [-0.14, 0, 0.05], [0, 0, 0], False),
               ("r hand", "RightForeArm", [-0.22, 0.03, 0.02], [0, -0.1, 0], True),
               ("head", "Head", [0, 0.12, 0.1], [0, 0, 0], False)]
    on_boris = [("pelvis", "Hips", [0.02, 0.03, 0.12], [0, 0, 0], True),
                ("back", "Chest", [0, 0.12, -0.12], [0, 2 * side, 0], True),
                ("front", "Chest", [0, 0.12, 0.12], [0, 0, 0], True),
                ("left", "LeftForeArm", [0.2, 0.02, 0.03], [0, 0, 0], True),
                ("right", "RightForeArm", [-0.2, 0.02, 0.03], [0, 0, 0], False)]
    return [Suit(ANNA, "Anna's", anna, on_anna, 120000, 48000, 1000, 100, (0.0131, 1 + 12e-6), (0.0119, 1)),
            Suit(ROOM, "corners", None, anchors, 150000, 58000, 1260, 140, (0, 1), (0, 1)),
            Suit(BORIS, "Boris's", boris, on_boris, 150000, 40000, 1230, 140, (-0.0087, 1 - 9e-6), (-0.0062, 1))]


TABLES = """
PRAGMA application_id = 1313817428; PRAGMA user_version = 1001;
CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE suit(id INTEGER PRIMARY KEY, json TEXT NOT NULL, clock_offset_ns REAL NOT NULL DEFAULT 0,
                  clock_rate REAL NOT NULL DEFAULT 1);
CREATE TABLE calibration(id INTEGER PRIMARY KEY, suit INTEGER NOT NULL DEFAULT 1, created_utc TEXT, json TEXT NOT NULL);
CREATE TABLE actor(id INTEGER PRIMARY KEY, suit INTEGER NOT NULL DEFAULT 1, created_utc TEXT, json TEXT NOT NULL);
CREATE TABLE pulse(id INTEGER PRIMARY KEY, suit INTEGER NOT NULL DEFAULT 1, sample INTEGER NOT NULL,
                   source INTEGER NOT NULL);
CREATE TABLE marker(id INTEGER PRIMARY KEY, suit INTEGER NOT NULL DEFAULT 1, sample INTEGER NOT NULL,
                    kind TEXT NOT NULL, label TEXT NOT NULL);
CREATE TABLE inertial(run INTEGER, suit INTEGER NOT NULL DEFAULT 1, board INTEGER, frame INTEGER, sample REAL,
    gx INTEGER, gy INTEGER, gz INTEGER, ax INTEGER, ay INTEGER, az INTEGER, mx INTEGER, my INTEGER, mz INTEGER,
    corrected INTEGER, PRIMARY KEY(run, suit, board, frame));
CREATE TABLE range(run INTEGER, pulse INTEGER, suit INTEGER NOT NULL DEFAULT 1, board INTEGER, detector TEXT,
    arrival_sample REAL, distance_m REAL, w_s REAL, w_t REAL, w_a REAL, sigma_m REAL,
    PRIMARY KEY(run, pulse, suit, board));
CREATE TABLE reference(suit INTEGER NOT NULL DEFAULT 1, time_ns INTEGER, px REAL, py REAL, pz REAL, q BLOB,
    PRIMARY KEY(suit, time_ns));
"""


class Writer:
    """Distances between suits believe the first guess of their clocks."""

    def __init__(self, path, seconds):
        self.suits, self.seconds = cast(), seconds
        self.random = random.Random(37)
        self.take = sqlite3.connect(path)
        self.take.executescript(TABLES)
        self.describe()
        for suit in self.suits:
            if suit.body:
                self.write_reference(suit)
                self.write_readings(suit)
        self.write_ranges()
        self.take.commit()
        self.take.close()

    def describe(self):
        room = next(suit for suit in self.suits if suit.number == ROOM)
        meta = {"format": "noctule-take", "uuid": "5e0c", "name": "elsewhere", "created_utc": "2026-05-04T10:00:00Z",
                "software": "elsewhere 3", "sample_rate_hz": room.rate_hz, "board_count": len(room.worn),
                "source_count": len(room.speakers), "pulse_interval_samples": room.interval, "pulse_cycles": 10,
                "drive_hz": room.carrier_hz, "take_kind": "motion", "state": "complete", "level": "readings",
                "reference_kind": "simulated",
                "subjects": json.dumps([{"room": True, "suits": [ROOM]}, {"name": "Boris", "suits": [BORIS]},
                                        {"name": "Anna", "suits": [ANNA]}])}
        self.take.executemany("INSERT INTO meta VALUES(?,?)", [(key, str(value)) for key, value in meta.items()])
        for suit in self.suits:
            self.take.execute("INSERT INTO suit VALUES(?,?,?,?)", (suit.number, json.dumps(suit.json()),
                                                                  suit.guess[0] * 1e9, suit.guess[1]))
            self.take.execute("INSERT INTO calibration(suit, json) VALUES(?,?)",
                              (suit.number, json.dumps(suit.calibration())))
            if suit.body:
                self.take.execute("INSERT INTO actor(suit, json) VALUES(?,?)",
                                  (suit.number, json.dumps(actor(suit.name, suit.body.size))))
                for label, at in (("begin", 0.2), ("end", REST_S)):
                    self.take.execute("INSERT INTO marker(suit, sample, kind, label) VALUES(?,?,'rest',?)",
                                      (suit.number, round(max(0, suit.suit_s(at)) * suit.rate_hz), label))

    def write_reference(self, suit):
        for k in range(int(self.seconds * 60)):
            root, local = suit.body.pose(k / 60)
            blob = struct.pack(f"<{4 * len(local)}d", *(x for q in local for x in q))
            self.take.execute("INSERT INTO reference VALUES(?,?,?,?,?,?)",
                              (suit.number, round(k * 1e9 / 60), *root, blob))

    def write_readings(self, suit):
        step = 1e-3
        gyro, accel = 17.5 / 2048, 156.9064 / 2048
        for frame in range(int((self.seconds - 0.1) * suit.board_hz)):
            own_s = frame / suit.board_hz
            t = suit.take_s(own_s)
            around = [suit.body.frames(t + k * step) for k in (-1, 0, 1)]
            for board, part in enumerate(suit.worn):
                (p0, q0), (p1, q1), (p2, q2) = (suit.board_at(frames, part) for frames in around)
                a = scaled(add(sub(p0, scaled(p1, 2)), p2), 1 / step ** 2)
                felt = turn(conjugate(q1), add(a, [0, G, 0]))
                rate = scaled(log(times(conjugate(q0), q2)), 1 / (2 * step))
                counts = [round(2048 + (x + self.random.gauss(0, 0.006)) / gyro) for x in rate]
                counts += [round(2048 + (x + self.random.gauss(0, 0.05)) / accel) for x in felt]
                self.take.execute("INSERT INTO inertial VALUES(0,?,?,?,?,?,?,?,?,?,?,NULL,NULL,NULL,0)",
                                  (suit.number, board, frame, own_s * suit.rate_hz, *counts))

    def pulses(self):
        """In the order in which they sound."""
        sent = []
        for suit in self.suits:
            for k in range(int(self.seconds * suit.rate_hz / suit.interval) - 1):
                sample = k * suit.interval
                take_s = suit.take_s(sample / suit.rate_hz)
                if take_s > 0:
                    sent.append((take_s, suit, sample, k % len(suit.speakers)))
        return sorted(sent, key=lambda pulse: pulse[0])

    def write_ranges(self):
        for number, (take_s, suit, sample, source) in enumerate(self.pulses(), 1):
            self.take.execute("INSERT INTO pulse VALUES(?,?,?,?)", (number, suit.number, sample, source))
            later_s = take_s + 0.01
            frames = {of.number: (of.body.frames(take_s), of.body.frames(later_s)) if of.body else (None, None)
                      for of in self.suits}
            speaker = suit.worn[suit.speakers[source]]
            place, q = suit.board_at(frames[suit.number][0], speaker)
            place = add(place, turn(q, [0.01, 0, 0]))
            for heard_by in self.suits:
                for board, part in enumerate(heard_by.worn):
                    if heard_by is suit and (part is speaker or suit.number == ROOM):
                        continue
                    at, later = (heard_by.board_at(f, part)[0] for f in frames[heard_by.number])
                    self.hear(number, take_s, suit, sample, place, turn(q, [0, 0, 1]), heard_by, board, at, later)

    def hear(self, pulse, take_s, suit, sample, place, normal, heard_by, board, at, later):
        way = sub(at, place)
        if dot(way, normal) < 0.1 * norm(way):
            return
        flight_s = norm(way) / C_M_PER_S
        way = sub(add(at, scaled(sub(later, at), flight_s / 0.01)), place)
        true_m = norm(way)
        measured_m = true_m + self.random.gauss(0, 0.002)
        arrival_s = take_s + measured_m / C_M_PER_S + OFFSET_S
        arrival = (heard_by.suit_s(arrival_s) + MIC_DELAY_S) * heard_by.rate_hz
        if arrival < 0:
            return
        if heard_by is not suit:
            believed_s = (heard_by.take_s(arrival / heard_by.rate_hz, heard_by.guess) -
                          suit.take_s(sample / suit.rate_hz, suit.guess))
            measured_m = C_M_PER_S * (believed_s - OFFSET_S - MIC_DELAY_S)
        self.take.execute("INSERT INTO range VALUES(0,?,?,?,'inflection',?,?,1,1,1,0.002)",
                          (pulse, heard_by.number, board, arrival, measured_m))


def correct_distances(path):
    """Distances between suits as they are after the clocks were corrected, which the writer knows."""
    suits = {suit.number: suit for suit in cast()}

    def corrected(sample, sent_by, arrival, heard_by):
        sent, heard = suits[sent_by], suits[heard_by]
        flight_s = heard.take_s(arrival / heard.rate_hz) - sent.take_s(sample / sent.rate_hz)
        return C_M_PER_S * (flight_s - OFFSET_S - MIC_DELAY_S)

    take = sqlite3.connect(path)
    take.create_function("corrected", 4, corrected)
    take.execute("UPDATE range SET distance_m = (SELECT corrected(sample, pulse.suit, arrival_sample, range.suit) "
                 "FROM pulse WHERE pulse.id = range.pulse)")
    take.commit()
    take.close()


def leave_out_what_may_be_null(path):
    take = sqlite3.connect(path)
    take.execute("UPDATE range SET w_s = NULL, w_t = NULL, w_a = NULL, sigma_m = NULL, detector = NULL")
    take.execute("UPDATE inertial SET corrected = 0")
    take.commit()
    take.close()
