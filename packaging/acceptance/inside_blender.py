# SPDX-License-Identifier: Apache-2.0
"""Runs inside Blender: imports a BVH file as an animator would and prints where every joint is in every frame.

  blender -b --factory-startup --python inside_blender.py -- FILE.bvh SCALE FPS
"""
import builtins
import json
import sys

import bpy

# Debian's Blender 3.4 opens BVH files with mode "rU", which its Python no longer knows.
plain_open = builtins.open
builtins.open = lambda file, mode="r", *rest, **named: plain_open(file, mode.replace("U", ""), *rest, **named)

path, scale, fps = sys.argv[sys.argv.index("--") + 1:]
bpy.context.scene.render.fps = int(fps)
bpy.ops.import_anim.bvh(filepath=path, global_scale=float(scale), axis_forward="-Z", axis_up="Y", frame_start=1)
armature = bpy.context.object
first, last = map(int, armature.animation_data.action.frame_range)
frames = []
for frame in range(first, last + 1):
    bpy.context.scene.frame_set(frame)
    joints = {}
    for bone in armature.pose.bones:
        x, y, z = armature.matrix_world @ bone.head
        joints[bone.name] = (x, z, -y)  # Blender is Z up
    frames.append(joints)
print("JOINTS " + json.dumps(frames))
