# SPDX-License-Identifier: Apache-2.0
"""Imported inside Blender before bpy: two things in which Debian's Blender 3.4 is older than its Python, the mode "rU" in
the import of BVH, numpy.bool in that of glTF."""
import builtins

import numpy

plain_open = builtins.open
builtins.open = lambda file, mode="r", *rest, **named: plain_open(file, mode.replace("U", ""), *rest, **named)
numpy.bool = bool
