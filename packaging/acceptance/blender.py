# SPDX-License-Identifier: Apache-2.0
"""Exports opened in Blender, the program that most animators open them in: are joints and skin where our own numbers
of the same run say, at the right frame rate, for the right time?"""
import json
import os
import pathlib
import shutil
import subprocess

import studio

PACKAGES = ("blender", "python3-numpy")  # its import of glTF wants the latter
STEP = 10  # frames
LARGEST_MM = 0.1  # Blender holds a bone's place as float32, BVH angles have seven decimals
LARGEST_DEG = 0.1
AGAIN = pathlib.Path(__file__).with_name("again_in_blender.py")
INSIDE = pathlib.Path(__file__).with_name("inside_blender.py")
MOTIONS = {"Boxing_Toes": 60, "01_01": 90, "01_03": 45}  # and frames per second; Blender rounds broken ones
SCALES = {"blender": 1.0, "motionbuilder": 0.01}  # presets, and the scale that Blender must be told for BVH
EXPORTS = (("bvh", "blender", "mannequin"), ("bvh", "motionbuilder", "mannequin"), ("fbx", "blender", "mannequin"),
           ("fbx", "motionbuilder", "mannequin"), ("fbx", "unity", "mannequin"), ("fbx", "unreal", "mannequin"),
           ("fbx", "blender", "none"), ("glb", "blender", "mannequin"))
HEAD_M = (1.2, 1.8)  # of a performer of 1.75 m who stands, and of grown bodies of others
OUR_BONES = "Head,LeftUpLeg,RightUpLeg"
MESHES = {"CesiumMan": studio.ROOT.parent / "shared/data/mesh/gltf/CesiumMan.glb",
          "MakeHuman": studio.ROOT.parent / "shared/data/mesh/makehuman/base.obj"}
WORN_FPS = 60
PICTURE = ("Boxing_Toes", "fbx", "blender", "mannequin")
PICTURE_SECOND = 12


def has_blender():
    """Installs it when that is possible; it is as big as all other packages together."""
    if shutil.which("apt-get") and os.geteuid() == 0:
        subprocess.run(["apt-get", "-qq", "install", "-y", "--no-install-recommends", *PACKAGES],
                       env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"}, capture_output=True)
    return shutil.which("blender") is not None


def seen_in_blender(file, *arguments):
    done = subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", INSIDE, "--",
                           file, *map(str, arguments)], capture_output=True, text=True,
                          env={**os.environ, "PATH": "/usr/bin:/bin"})  # the first python3 on it lends its modules
    lines = [line for line in done.stdout.splitlines() if line.startswith("SEEN ")]
    if done.returncode != 0 or len(lines) != 1:
        raise RuntimeError(f"Blender could not open {file}:\n{done.stdout[-1500:]}{done.stderr[-1500:]}")
    return json.loads(lines[0].removeprefix("SEEN "))


def faults(seen, frames, fps):
    """What is wrong, in words."""
    complaints = []
    if seen["missing"]:
        complaints.append(f"no {', '.join(seen['missing'])}")
    if max(seen["joint_mm"], seen["skin_mm"] or 0) > LARGEST_MM:
        complaints.append(f"{max(seen['joint_mm'], seen['skin_mm'] or 0):.2f} mm off")
    if seen["frames"] != frames or abs(seen["starts_at"]) > 0.01:
        complaints.append(f"{seen['frames']} frames from {seen['starts_at']:g} instead of {frames} from 0")
    if abs(seen["fps"] - fps) > 1e-3:
        complaints.append(f"{seen['fps']:g} frames per second instead of {fps:g}")
    if not HEAD_M[0] < seen["head_m"] < HEAD_M[1]:
        complaints.append(f"the head is {seen['head_m']:.2f} m high")
    if seen["left_m"] < 0.1:
        complaints.append("the left side is not on the left")
    return complaints


def make_take(motion, folder, name=None, *options):
    take = folder / f"{name or motion}.noctule"
    studio.simulate(studio.REAL_MOTIONS / f"{motion}.bvh", take, "--level", "readings", *options)
    studio.process(take, "AGD", "AGD")
    return take


def rows_of(motion, fps, folder):
    """One row per file, and what is wrong with any of them."""
    take, table, skin = make_take(motion, folder), folder / f"{motion}.csv", folder / f"{motion}.skin"
    studio.batch("export", take, "--csv", table, "--fps", fps, "--overwrite")
    subprocess.run([studio.BUILD / "skin_points", take, str(fps), str(STEP), skin], check=True)
    frames = len(table.read_text().splitlines()) - 1
    rows, missed = [], []
    for export in EXPORTS:
        extension, preset, mesh = export
        file = folder / f"{motion}_{preset}_{mesh}.{extension}"
        body = [] if extension == "bvh" else ["--mesh", mesh]
        studio.batch("export", take, f"--{extension}", file, "--preset", preset, *body, "--fps", fps, "--overwrite")
        has_skin = extension != "bvh" and mesh != "none"
        picture = [folder / "picture.png", round(PICTURE_SECOND * fps)] if (motion, *export) == PICTURE else []
        seen = seen_in_blender(file, table, skin if has_skin else "-", fps, SCALES.get(preset, 1), STEP, OUR_BONES, "",
                               *picture)
        missed += [f"{file.name}: {what}" for what in faults(seen, frames, fps)]
        rows.append([motion, extension.upper(), preset, f"{fps:g}", seen["frames"], seen["joints"],
                     studio.number(seen["joint_mm"], 4), studio.number(seen["skin_mm"], 4) if has_skin else "none"])
    return rows, missed


def worn_rows(take, folder):
    """The motion on bodies of others, whose bones have names of their own and whose feet keep their place."""
    rows, missed = [], []
    for name, mesh in MESHES.items():
        if not mesh.exists():
            missed.append(f"{name}: {mesh} is missing")
            continue
        table, skin = folder / f"{name}.csv", folder / f"{name}.skin"
        subprocess.run([studio.BUILD / "skin_points", take, str(WORN_FPS), str(STEP), skin, mesh, table], check=True)
        frames = len(table.read_text().splitlines()) - 1
        for extension in ("fbx", "glb"):
            file = folder / f"{take.stem}_{name}.{extension}"
            done = json.loads(studio.batch("export", take, f"--{extension}", file, "--preset", "blender", "--mesh", mesh,
                                           "--overwrite", "--fps", WORN_FPS, "--json"))
            bones = done["takes"][0]["bones"]
            wanted = ",".join(bones[joint] for joint in OUR_BONES.split(","))
            seen = seen_in_blender(file, table, skin, WORN_FPS, 1, STEP, wanted, "")
            missed += [f"{file.name}: {what}" for what in faults(seen, frames, WORN_FPS)]
            rows.append([take.stem, extension.upper(), name, f"{WORN_FPS:g}", seen["frames"], seen["joints"],
                         studio.number(seen["joint_mm"], 4), studio.number(seen["skin_mm"], 4)])
    return rows, missed


def write_again(file, again):
    subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", AGAIN, "--",
                    file, again, str(WORN_FPS)], check=True, capture_output=True,
                   env={**os.environ, "PATH": "/usr/bin:/bin"})


def bvh_again_row(take, folder):
    """BVH has no skin: the motion, as it is understood. Blender writes Z up."""
    file, again = folder / f"{take.stem}_first.bvh", folder / f"{take.stem}_bvh_again.bvh"
    studio.batch("export", take, "--bvh", file, "--preset", "blender", "--overwrite", "--fps", WORN_FPS)
    write_again(file, again)
    seen = json.loads(subprocess.run([studio.BUILD / "same_motion", file, again, str(STEP)], check=True,
                                     capture_output=True, text=True).stdout)
    good = seen["joint_mm"] <= LARGEST_MM and seen["turn_deg"] <= LARGEST_DEG and len(set(seen["frames"])) == 1
    row = [take.stem, "BVH", "written again as BVH", f"{WORN_FPS:g}", seen["frames"][1], seen["joints"],
           studio.number(seen["joint_mm"], 4), "none"]
    return row, [] if good else [f"{again.name}: {seen}"]


def again_rows(take, folder):
    """Exports that Blender opened and wrote again, as our importer reads both."""
    row, missed = bvh_again_row(take, folder)
    rows = [row]
    for extension in ("glb", "fbx"):
        file = folder / f"{take.stem}_first.{extension}"
        studio.batch("export", take, f"--{extension}", file, "--preset", "blender", "--overwrite", "--fps", WORN_FPS)
        for other in ("glb", "fbx"):
            again = folder / f"{take.stem}_{extension}_again.{other}"
            write_again(file, again)
            seen = json.loads(subprocess.run([studio.BUILD / "same_scene", file, again, str(WORN_FPS), str(STEP)],
                                             check=True, capture_output=True, text=True).stdout)
            if max(seen["skin_mm"], seen["joint_mm"]) > LARGEST_MM or seen["turn_deg"] > LARGEST_DEG:
                missed.append(f"{again.name}: {seen}")
            rows.append([take.stem, extension.upper(), f"written again as {other.upper()}", f"{WORN_FPS:g}",
                         seen["frames"], seen["bones"], studio.number(seen["joint_mm"], 4),
                         studio.number(seen["skin_mm"], 4)])
    return rows, missed


def stack_rows(motion, folder):
    """Two takes of one performer in one FBX: each is an action of its own, and the take's."""
    takes = [folder / f"{motion}.noctule", make_take(motion, folder, f"{motion}_short", "--duration", 8)]
    file, fps = folder / "stacks.fbx", WORN_FPS
    studio.batch("export", *takes, "--stacks", "--fbx", file, "--preset", "blender", "--fps", fps, "--overwrite")
    rows, missed = [], []
    for take in takes:
        table = folder / f"{take.stem}_{fps}.csv"
        studio.batch("export", take, "--csv", table, "--fps", fps, "--overwrite")
        frames = len(table.read_text().splitlines()) - 1
        seen = seen_in_blender(file, table, "-", fps, 1, STEP, OUR_BONES, take.stem)
        missed += [f"{file.name}, {take.stem}: {what}" for what in faults(seen, frames, fps)]
        if len(seen["actions"]) != len(takes):
            missed.append(f"{file.name}: {len(seen['actions'])} actions instead of {len(takes)}")
        rows.append([take.stem, "FBX", "one of several", f"{fps:g}", seen["frames"], seen["joints"],
                     studio.number(seen["joint_mm"], 4), "none"])
    return rows, missed


def figure(_):
    if not has_blender():
        return "Skipped: Blender is not installed and could not be (apt-get install "\
               "--no-install-recommends blender python3-numpy).\n"
    folder = studio.OUT / "blender"
    folder.mkdir(parents=True, exist_ok=True)
    rows, missed = [], []
    for motion, fps in MOTIONS.items():
        of_motion, wrong = rows_of(motion, fps, folder)
        rows += of_motion
        missed += wrong
    last = list(MOTIONS)[-1]
    for more, wrong in (worn_rows(folder / f"{last}.noctule", folder), again_rows(folder / f"{last}.noctule", folder),
                        stack_rows(last, folder)):
        rows += more
        missed += wrong
    text = studio.markdown_table(["motion", "file", "preset or body", "frames per second", "frames", "bones",
                                  "joints, mm", "skin, mm"], rows)
    text += f"\nLargest distances from our own numbers, every {STEP}th frame, world positions.\n"
    text += ("GLB is opened for writing again with *Bone Dir: Blender*, so that bones keep the file's axes. With Blender's "
             "default, Temperance,\nboth shoulders stand at gimbal lock: the Euler angles of its FBX writer, in single "
             "precision, are then up to 4 degrees off\nin single frames, as Blender itself shows when it opens that "
             "FBX.\n")
    if missed:
        raise studio.Missed(missed, text)
    return text
