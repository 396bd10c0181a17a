# SPDX-License-Identifier: Apache-2.0
"""Welch 2018, section 4, as numbers: the table over several seeds, figures 3 to 5, and more people. Then two whole suits
alone and joined, with and without anchors, and the same takes as points."""
import json
import shutil

import built_tests
import studio

SEEDS = (201, 202, 203)
CASTS = {"handshake": ("pair_handshake",), "salsa": ("pair_salsa",)}
RUNS = {"alone": ("off", "off"), "between": ("on", "off"), "room": ("off", "on"), "between and room": ("on", "on"),
        "a quarter of the ranges": ("on", "on", "--select", 0.25)}
EVERY_SEED = ("between", "between and room")  # the other runs: the first seed
POINTS = ("comocap", "ms-comocap", "environment")
LIMITS = {"Hips": 10, "hands": 15, "heading_deg": 1}  # between, without a room


def cast_of(name, folder):
    """The cast of the resources with two whole suits; its motions lie beside it."""
    casts = studio.ROOT / "resources" / "casts"
    cast = json.loads((casts / f"{name}.json").read_text())
    shutil.copy(casts / "ceiling_4.json", folder)
    shutil.copy(studio.ROOT / "resources" / "suits" / "default.json", folder)
    for subject in cast["subjects"]:
        subject["suit"] = "default.json"
        for source in CASTS[name]:
            shutil.copy(studio.MORE_MOTIONS / source / subject["motion"], folder)
    path = folder / f"worn_{name}.json"
    path.write_text(json.dumps(cast))
    return path


def nees_text(values):
    stated = [value for value in values if value is not None]
    return f"{min(stated):.1f} to {max(stated):.1f}" if stated else "not stated"


def row_of(take, label, options):
    between, room, *more = options
    studio.batch("process", take, "--between", between, "--room", room, "--run-name", label, *more)
    found = studio.evaluate(take, label)
    hands = [pair["rms_mm"] for pair in found["between"] if pair["from"] != "Hips"]
    hips = next(pair for pair in found["between"] if pair["from"] == "Hips")
    return {"angles": [subject["mean_deg"] for subject in found["subjects"]], "Hips": hips["rms_mm"],
            "nees": [pair["nees"] for pair in found["between"]], "hands": max(hands), "world": hips["rms_world_mm"], "heading_deg": hips["heading_deg"],
            "root": max(subject["root"]["position_m"] for subject in found["subjects"]) * 1000}


def points_of(take, name, seed):
    rows, rms = [], {}
    for estimator in POINTS:
        table = take.with_suffix(f".{estimator}.csv")
        studio.batch("process", take, "--estimator", estimator, "--points", table, "--overwrite")
        found = json.loads(studio.batch("evaluate", take, "--points", table, "--json"))["tables"][0]
        rms[estimator] = found["rms_mm"]
        rows.append([name, seed, estimator, *(studio.number(found[key], 1) for key in
                                              ("rms_mm", "between_rms_mm", "between_near_rms_mm")),
                     studio.number(found["nees"])])
    return rows, rms


def worn(missed):
    folder = studio.OUT / "cast"
    folder.mkdir(parents=True, exist_ok=True)
    rows, points = [], []
    for name in CASTS:
        cast = cast_of(name, folder)
        for seed in SEEDS:
            take = folder / f"worn_{name}_{seed}.noctule"
            studio.batch("simulate", "--cast", cast, "--level", "readings", "--scenario", "nominal", "--seed", seed,
                         "--out", take, "--overwrite")
            more, rms = points_of(take, name, seed)
            points += more
            if not rms["comocap"] < rms["ms-comocap"] < rms["environment"]:
                missed.append(f"{name}, seed {seed}: points in another order than comocap, ms-comocap, environment")
            for label, options in RUNS.items():
                if seed != SEEDS[0] and label not in EVERY_SEED:
                    continue
                found = row_of(take, label, options)
                rows.append([name, seed, label, " / ".join(studio.number(x) for x in found["angles"]),
                             *(studio.number(found[key], 1) for key in ("Hips", "hands", "world", "root")),
                             studio.number(found["heading_deg"]), nees_text(found["nees"])])
                if label == "between":
                    missed += [f"{name}, seed {seed}: {key} {found[key]:.1f}, wanted {limit}"
                               for key, limit in LIMITS.items() if found[key] > limit]
    return ("\n### Two whole suits, readings level, nominal\n\nMean angle of A / B in degrees; error in mm (rms) of the "
            "vector between the pelvises, of the worst pair of hands (common heading taken off), of the pelvises' "
            "vector in the world, of the worse root against its start; relative heading in degrees; NEES of the vectors "
            "between pelvises and hands, from the least to the largest. Runs that are there once: first seed.\n\n" +
            studio.markdown_table(["cast", "seed", "run", "angles", "pelvises", "hands", "in the world", "root",
                                   "heading", "NEES"], rows) +
            "\nThe same takes as free points, one per housing: error in mm (rms) of all points, of the vectors between "
            "points of both people, of those nearer than 0.3 m. Soft tissue and errors of mounting count.\n\n" +
            studio.markdown_table(["cast", "seed", "estimator", "points", "between", "near", "NEES"], points))


def figure(_):
    text = ("### Two people, 13 transceivers each, 4 in the room, 2 mm, 100 Hz\n\nAverages over 20 seeds; turn: the "
            "largest. Motions: CMU 18_01 twice and 60_05 with 61_05.\n\n" +
            built_tests.run("test_core_cooperative", "Cast.*", "^cast: ", NOCTULE_CAST_SEEDS="20"))
    missed = []
    text += worn(missed)
    if missed:
        raise studio.Missed(missed, text)
    return text
