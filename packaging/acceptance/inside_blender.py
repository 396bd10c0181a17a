# SPDX-License-Identifier: Apache-2.0
"""Runs inside Blender: imports an exported file as an animator would, and holds every tenth frame against our own
numbers: joints from a CSV of positions, skin from a file of skin_points. Prints one line of JSON.

  blender -b --factory-startup --python inside_blender.py -- FILE JOINTS.csv SKIN|- FPS SCALE STEP BONES ACTION
      [PICTURE.png FRAME]

BONES: those of Head, LeftUpLeg and RightUpLeg, with commas. ACTION: how the motion's name ends, of a file of several.
"""
import csv
import json
import pathlib
import sys

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import repaired_blender  # noqa: E402, F401

import bpy  # noqa: E402
import mathutils  # noqa: E402

OTHER_NAMES = {"Spine2": "Chest"}  # HumanIK's


def import_file(path, fps, scale):
    """The number of the frame that shows time 0."""
    scene = bpy.context.scene
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    if path.suffix == ".fbx":
        scene.render.fps = 24  # what the scene runs at is the file's business
        bpy.ops.import_scene.fbx(filepath=str(path))
        return 1
    scene.render.fps, scene.render.fps_base = round(fps), round(fps) / fps
    if path.suffix == ".bvh":
        bpy.ops.import_anim.bvh(filepath=str(path), global_scale=scale, axis_forward="-Z", axis_up="Y", frame_start=1)
        return 1
    bpy.ops.import_scene.gltf(filepath=str(path))
    return 0


def ours(point):
    """Blender is Z up."""
    x, y, z = point
    return numpy.array([x, z, -y])


def skin_seen(mesh):
    shown = mesh.evaluated_get(bpy.context.evaluated_depsgraph_get())
    data = shown.to_mesh()
    points = numpy.empty(len(data.vertices) * 3, dtype=numpy.float32)
    data.vertices.foreach_get("co", points)
    shown.to_mesh_clear()
    matrix = numpy.array(mesh.matrix_world)
    placed = points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
    return numpy.stack([placed[:, 0], placed[:, 2], -placed[:, 1]], axis=1)


def joints_in_csv(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    names = [column[:-2] for column in rows[0] if column.endswith(".x")]
    return [{name: numpy.array([float(row[f"{name}.{axis}"]) for axis in "xyz"]) for name in names} for row in rows]


def skin_in_file(path):
    if path == "-":
        return None
    data = pathlib.Path(path).read_bytes()
    frames, points = numpy.frombuffer(data, numpy.uint32, 2)
    return numpy.frombuffer(data, numpy.float32, offset=8).reshape(frames, points, 3)


def compare(armature, mesh, joints, skin, first, step):
    """Largest distances in metres; joints that are not there by name."""
    joint_m = skin_m = 0
    missing = set()
    for index in range(0, len(joints), step):
        bpy.context.scene.frame_set(first + index)
        seen = {OTHER_NAMES.get(bone.name, bone.name): ours(armature.matrix_world @ bone.head)
                for bone in armature.pose.bones}
        missing |= set(joints[index]) - set(seen)
        for name in set(joints[index]) & set(seen):
            joint_m = max(joint_m, float(numpy.linalg.norm(seen[name] - joints[index][name])))
        if skin is not None:
            difference = skin_seen(mesh) - skin[index // step]
            skin_m = max(skin_m, float(numpy.sqrt((difference ** 2).sum(axis=1)).max()))
    return joint_m, skin_m, sorted(missing)


def take_picture(path, frame, joints):
    """The body as Workbench shows it, the camera in front of where it faces."""
    scene = bpy.context.scene
    scene.frame_set(frame)
    middle = mathutils.Vector((joints["Hips"][0], -joints["Hips"][2], joints["Hips"][1] - 0.05))
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.lens = 60
    camera.location = middle + mathutils.Vector((1.9, -4.2, 0.7))
    camera.rotation_euler = (middle - camera.location).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera
    bpy.ops.mesh.primitive_plane_add(size=6, location=(middle.x, middle.y, 0))
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.display.shading.light = "STUDIO"
    scene.display.shading.show_shadows = scene.display.shading.show_cavity = True
    scene.render.resolution_x, scene.render.resolution_y = 480, 480
    scene.render.image_settings.color_mode, scene.render.image_settings.compression = "RGB", 100
    scene.render.dither_intensity = 0
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


def main():
    file, table, skin_file, fps, scale, step, bones, wanted, *picture = sys.argv[sys.argv.index("--") + 1:]
    first = import_file(pathlib.Path(file), float(fps), float(scale))
    armature = next(thing for thing in bpy.data.objects if thing.type == "ARMATURE")
    mesh = next((thing for thing in bpy.data.objects
                 if any(m.type == "ARMATURE" for m in thing.modifiers)), None)
    skin, joints = skin_in_file(skin_file), joints_in_csv(table)
    if skin is not None and (mesh is None or len(mesh.data.vertices) != skin.shape[1]):
        raise SystemExit("the body is not there, or not whole")
    actions = sorted(action.name for action in bpy.data.actions)
    if wanted:
        armature.animation_data.action = next(a for a in bpy.data.actions if wanted in a.name.split("|"))
    action = armature.animation_data.action
    begin, end = action.frame_range
    joint_m, skin_m, missing = compare(armature, mesh, joints, skin, first, int(step))
    scene = bpy.context.scene
    scene.frame_set(first)
    head, left, right = (ours(armature.matrix_world @ armature.pose.bones[name].head) for name in bones.split(","))
    print("SEEN " + json.dumps({
        "joint_mm": 1000 * joint_m, "skin_mm": None if skin is None else 1000 * skin_m, "missing": missing,
        "joints": len(armature.pose.bones), "frames": round(end - begin) + 1, "starts_at": begin - first,
        "fps": scene.render.fps / scene.render.fps_base, "head_m": float(head[1]), "left_m": float((left - right)[0]),
        "action": action.name, "actions": actions, "scale": max(armature.scale)}))
    if picture:
        take_picture(picture[0], int(picture[1]) + first, joints[int(picture[1])])


main()
