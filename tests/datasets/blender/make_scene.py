"""Saves a small scene: blender --background --factory-startup --python make_scene.py -- FILE.blend

A checkered wall 10 units before a camera that moves by 0.5 units to the right and turns by 0.01 a
frame; a box that stands still 5 units before it; sky above the wall. Frames 1 to 3, 64 x 48, Cycles.
"""

import sys

import bpy
import mathutils

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.render.resolution_x, scene.render.resolution_y = 64, 48
scene.frame_start, scene.frame_end = 1, 3

material = bpy.data.materials.new("checker")
material.use_nodes = True
nodes = material.node_tree.nodes
checker = nodes.new("ShaderNodeTexChecker")
checker.inputs["Scale"].default_value = 9
material.node_tree.links.new(checker.outputs["Color"], nodes["Principled BSDF"].inputs["Base Color"])

bpy.ops.mesh.primitive_plane_add(size=24, location=(0, 0, -10))
bpy.context.object.data.materials.append(material)
bpy.context.object.location.y = -11  # its upper edge is at y = 1
bpy.ops.mesh.primitive_cube_add(size=1, location=(0.7, -0.4, -5.5))
bpy.context.object.data.materials.append(material)
bpy.ops.object.light_add(type="SUN", location=(0, 0, 0))
bpy.context.object.data.energy = 3
bpy.context.object.matrix_world = mathutils.Matrix.Rotation(0.4, 4, "X")

bpy.ops.object.camera_add(location=(0, 0, 0), rotation=(0, 0, 0))
camera = bpy.context.object
camera.data.lens, camera.data.sensor_width = 36, 36
camera.data.clip_start, camera.data.clip_end = 0.1, 100
scene.camera = camera
for frame in range(0, 5):
    camera.location.x = 0.5 * (frame - 1)
    camera.keyframe_insert("location", frame=frame)
    camera.rotation_euler.y = 0.01 * (frame - 1)
    camera.keyframe_insert("rotation_euler", frame=frame)
for curve in camera.animation_data.action.fcurves:
    for key in curve.keyframe_points:
        key.interpolation = "LINEAR"
world = bpy.data.worlds.new("sky")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.2, 0.4, 0.8, 1)
scene.world = world
bpy.ops.wm.save_as_mainfile(filepath=sys.argv[sys.argv.index("--") + 1])
