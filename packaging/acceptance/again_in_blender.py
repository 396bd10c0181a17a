# SPDX-License-Identifier: Apache-2.0
"""Runs inside Blender: imports an exported file and writes it again, as an animator hands it on.

  blender -b --factory-startup --python again_in_blender.py -- FILE.bvh|glb|fbx AGAIN.bvh|glb|fbx FPS
"""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import repaired_blender  # noqa: E402, F401

import bpy  # noqa: E402


def main():
    file, again, fps = sys.argv[sys.argv.index("--") + 1:]
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    scene = bpy.context.scene
    scene.render.fps = round(float(fps))
    if file.endswith(".bvh"):
        bpy.ops.import_anim.bvh(filepath=file, update_scene_fps=True, update_scene_duration=True)
    elif file.endswith(".fbx"):
        bpy.ops.import_scene.fbx(filepath=file)
    else:  # bones keep the file's axes; with others the FBX writer's Euler angles reach gimbal lock
        bpy.ops.import_scene.gltf(filepath=file, bone_heuristic="BLENDER")
    begins, ends = zip(*(action.frame_range for action in bpy.data.actions))
    scene.frame_start, scene.frame_end = round(min(begins)), round(max(ends))
    if again.endswith(".bvh"):
        bpy.context.view_layer.objects.active = next(thing for thing in bpy.data.objects if thing.type == "ARMATURE")
        bpy.ops.export_anim.bvh(filepath=again, frame_start=scene.frame_start, frame_end=scene.frame_end)
    elif again.endswith(".fbx"):
        bpy.ops.export_scene.fbx(filepath=again, add_leaf_bones=False, bake_anim_simplify_factor=0)
    else:
        bpy.ops.export_scene.gltf(filepath=again, export_format="GLB", export_frame_range=True)


main()
