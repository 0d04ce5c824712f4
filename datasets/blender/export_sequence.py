"""Exports a Blender scene as a sequence of warplut: rendered frames with jitter, references, depth,
motion, cameras and the manifest.

    blender --background FILE.blend --python export_sequence.py -- --out FOLDER [OPTION...]

For Blender 3.4 and later, with Cycles or EEVEE. The .blend file is not changed. Rendered frames
take one point of each pixel (a pixel filter of width 0.01), so that depth and motion do not mix at
edges; `--light-samples` says how many paths of light start there. A file that exists is rendered
again unless `--resume` is given. The manifest is written last.
"""

import argparse
import json
import os
import struct
import sys

import bpy

POINT_FILTER = 0.01  # width of the pixel filter, in pixels: a point
BACKGROUND = 1e10  # depth that Blender writes where there is no surface


class ExportError(Exception):
    """A sentence for the user."""


def parse_arguments():
    arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    parser = argparse.ArgumentParser(
        prog="blender --background FILE.blend --python export_sequence.py --",
        description="Exports the scene as a sequence of warplut.",
    )
    parser.add_argument("--out", required=True, help="folder of the sequence")
    parser.add_argument("--width", type=int, help="width of the references (default: the scene's)")
    parser.add_argument(
        "--height", type=int, help="height of the references (default: the scene's)"
    )
    parser.add_argument("--scale", type=float, default=2, help="upscale factor in [1, 4]")
    parser.add_argument("--frames", help="first and last frame, as A:B (default: the scene's)")
    parser.add_argument("--samples", type=int, default=256, help="samples of a reference's pixel")
    parser.add_argument(
        "--light-samples",
        type=int,
        default=64,
        help="paths of light at the point of a rendered pixel",
    )
    parser.add_argument("--name", help="name of the sequence (default: that of the .blend file)")
    parser.add_argument("--resume", action="store_true", help="keep frames that are there")
    return parser.parse_args(arguments)


def halton(index, base):
    """Element `index` >= 1 of the radical inverse; the jitter of datasets/jitter.h."""
    value, digit = 0.0, 1.0
    while index > 0:
        digit /= base
        value += digit * (index % base)
        index //= base
    return value


def jitter_cycle(scale):
    count = int(8 * scale * scale)
    return [(halton(i, 2) - 0.5, halton(i, 3) - 0.5) for i in range(1, count + 1)]


def frame_range(text, scene):
    if text is None:
        return scene.frame_start, scene.frame_end
    try:
        first, last = (int(part) for part in text.split(":"))
    except ValueError:
        raise ExportError(f"--frames is '{text}'; expected A:B") from None
    if not 0 <= first <= last:
        raise ExportError(f"--frames is '{text}'; expected 0 <= A <= B")
    return first, last


def check(arguments, scene):
    """The sizes (output, render), or an ExportError for what cannot be exported."""
    render = scene.render
    percent = render.resolution_percentage / 100
    output = (
        arguments.width or round(render.resolution_x * percent),
        arguments.height or round(render.resolution_y * percent),
    )
    if not 1 <= arguments.scale <= 4:
        raise ExportError(f"--scale is {arguments.scale}; expected 1 to 4")
    if min(output) < 16 or max(output) > 16384:
        raise ExportError(f"the size is {output[0]} x {output[1]}; expected 16 to 16384 on a side")
    if arguments.samples < 1 or arguments.light_samples < 1:
        raise ExportError("--samples and --light-samples are at least 1")
    if render.engine not in ("CYCLES", "BLENDER_EEVEE", "BLENDER_EEVEE_NEXT"):
        raise ExportError(f"the engine is {render.engine}; expected Cycles or EEVEE")
    if render.pixel_aspect_x != render.pixel_aspect_y:
        raise ExportError("the pixels are not square; expected a pixel aspect of 1")
    for camera in {c for c in [scene.camera] + [m.camera for m in scene.timeline_markers] if c}:
        if camera.data.type not in ("PERSP", "ORTHO"):
            raise ExportError(
                f"camera '{camera.name}' is panoramic; expected perspective or orthographic"
            )
        animation = camera.data.animation_data
        curves = list(animation.drivers) if animation else []
        if animation and animation.action:
            curves += animation.action.fcurves
        if any(curve.data_path in ("shift_x", "shift_y") for curve in curves):
            raise ExportError(
                f"the shift of camera '{camera.name}' is animated; the jitter needs it"
            )
    if scene.camera is None:
        raise ExportError("the scene has no camera")
    return output, tuple(max(1, round(side / arguments.scale)) for side in output)


def prepare(scene):
    """What every pass of the export shares."""
    render = scene.render
    render.resolution_percentage = 100
    render.use_border = False
    render.use_multiview = False
    render.use_compositing = False
    render.use_sequencer = False
    render.use_motion_blur = False  # Blender writes no motion vectors with it
    render.film_transparent = False
    render.use_overwrite = True
    render.use_placeholder = False
    settings = render.image_settings
    settings.file_format = "OPEN_EXR_MULTILAYER"
    settings.color_depth = "32"
    settings.exr_codec = "ZIP"
    layers = [layer for layer in scene.view_layers if layer.use]
    if not layers:
        raise ExportError("no view layer is switched on")
    for layer in layers[1:]:
        layer.use = False
    layers[0].use_pass_combined = True
    layers[0].use_pass_z = True
    layers[0].use_pass_vector = True
    if render.engine == "CYCLES":
        scene.cycles.use_denoising = False
        scene.cycles.use_adaptive_sampling = False
        scene.cycles.use_animated_seed = True


def set_sampling(scene, samples, point):
    """`point`: all samples of a pixel at its centre; else the default filter of Blender."""
    if scene.render.engine == "CYCLES":
        scene.cycles.samples = samples
        scene.cycles.pixel_filter_type = "BLACKMAN_HARRIS"
        scene.cycles.filter_width = POINT_FILTER if point else 1.5
    else:
        scene.eevee.taa_render_samples = 1 if point else samples
        scene.render.filter_size = POINT_FILTER if point else 1.5


def shift_unit(camera, size):
    """The pixels that a camera shift of 1 stands for."""
    fit = camera.data.sensor_fit
    if fit == "AUTO":
        fit = "HORIZONTAL" if size[0] >= size[1] else "VERTICAL"
    return size[0] if fit == "HORIZONTAL" else size[1]


def render_frame(scene, frame, size, jitter, path):
    """Renders `frame` at `size` to `path`, samples off the pixel centres by `jitter`, y down."""
    scene.frame_set(frame)
    camera = scene.camera
    scene.render.resolution_x, scene.render.resolution_y = size
    unit = shift_unit(camera, size)
    shift = camera.data.shift_x, camera.data.shift_y
    part = path[: -len(".exr")] + ".part.exr"
    try:
        camera.data.shift_x = shift[0] + jitter[0] / unit
        camera.data.shift_y = shift[1] - jitter[1] / unit
        scene.render.filepath = part
        bpy.ops.render.render(write_still=True)
    finally:
        camera.data.shift_x, camera.data.shift_y = shift
    if not os.path.exists(part):
        raise ExportError(f"Blender wrote no {part}")
    os.replace(part, path)


def channels_of(path):
    """The names of the channels in an OpenEXR file of one part."""
    with open(path, "rb") as file:
        data = file.read(1 << 20)

    def text(at):
        end = data.index(b"\0", at)
        return data[at:end].decode("utf-8", "replace"), end + 1

    at = 8
    while data[at : at + 1] != b"\0":
        name, at = text(at)
        _, at = text(at)
        (size,) = struct.unpack_from("<i", data, at)
        at += 4
        if name == "channels":
            names, end = [], at + size
            while at < end - 1:
                channel, at = text(at)
                names.append(channel)
                at += 16
            return names
        at += size
    raise ExportError(f"{path} has no channels")


def channel(names, layer, *endings):
    for ending in endings:
        if f"{layer}.{ending}" in names:
            return f"{layer}.{ending}"
    raise ExportError(
        f"layer '{layer}' has no channel {' or '.join(endings)}; it has {', '.join(names)}"
    )


def matrix(rows):
    return [value for row in rows for value in row]


def camera_of(scene, frame, size):
    """The manifest's camera of a frame, without jitter."""
    scene.frame_set(frame)
    graph = bpy.context.evaluated_depsgraph_get()
    camera = scene.camera.evaluated_get(graph)
    return {
        "view": matrix(camera.matrix_world.normalized().inverted()),
        "projection": matrix(
            camera.calc_matrix_camera(graph, x=size[0], y=size[1], scale_x=1, scale_y=1)
        ),
    }


def cuts_of(scene, first, last):
    """The frames that another camera takes than the frame before."""
    cuts, before = [], None
    for frame in range(first, last + 1):
        scene.frame_set(frame)
        if before not in (None, scene.camera):
            cuts.append(frame)
        before = scene.camera
    return cuts


def manifest_of(arguments, scene, sizes, frames, layer):
    output, render = sizes
    first, last = frames
    cycle = jitter_cycle(arguments.scale)
    names = channels_of(os.path.join(arguments.out, "lr", f"{first:04d}.exr"))
    color = [channel(names, layer, f"Combined.{c}") for c in "RGB"]
    depth = [channel(names, layer, "Depth.Z", "Depth.V")]
    motion = [channel(names, layer, f"Vector.{c}") for c in "XY"]
    scene.frame_set(first)
    near, far = scene.camera.data.clip_start, scene.camera.data.clip_end

    def depth_stream(folder, grid):
        return {
            "path": f"{folder}/%04d.exr", "grid": grid, "channels": depth, "kind": "linear",
            "near": near, "far": far, "background": BACKGROUND,
        }

    def motion_stream(folder, grid):
        return {
            "path": f"{folder}/%04d.exr", "grid": grid, "channels": motion, "units": "pixels",
            "direction": "current-to-previous", "y": "up",
        }

    name = arguments.name or os.path.splitext(os.path.basename(bpy.data.filepath))[0] or "blender"
    return {
        "format": "warplut-sequence",
        "version": 2,
        "name": name,
        "frames": {"first": first, "count": last - first + 1},
        "render": {"width": render[0], "height": render[1]},
        "output": {"width": output[0], "height": output[1]},
        "color_space": "linear",
        "streams": {
            "color": {"path": "lr/%04d.exr", "grid": "render", "channels": color},
            "depth": depth_stream("lr", "render"),
            "motion": motion_stream("lr", "render"),
            "reference": {"path": "hr/%04d.exr", "grid": "output", "channels": color},
            "reference_depth": depth_stream("guides", "output"),
            "reference_motion": motion_stream("guides", "output"),
        },
        "jitter": {
            "units": "render-pixels", "y": "down",
            "offsets": [list(cycle[(f - first) % len(cycle)]) for f in range(first, last + 1)],
        },
        "camera": [camera_of(scene, frame, output) for frame in range(first, last + 1)],
        "cuts": cuts_of(scene, first, last),
    }


def write_manifest(folder, manifest):
    path = os.path.join(folder, "sequence.json")
    with open(path + ".part", "w", encoding="utf-8") as file:
        json.dump(manifest, file, indent=1)
        file.write("\n")
        file.flush()
        os.fsync(file.fileno())
    os.replace(path + ".part", path)


def export(arguments):
    scene = bpy.context.scene
    output, render = check(arguments, scene)
    first, last = frame_range(arguments.frames, scene)
    prepare(scene)
    arguments.out = os.path.abspath(arguments.out)
    cycle = jitter_cycle(arguments.scale)
    passes = (
        ("lr", render, arguments.light_samples, True),
        ("guides", output, 1, True),
        ("hr", output, arguments.samples, False),
    )
    layer = next(layer.name for layer in scene.view_layers if layer.use)
    for folder, size, samples, point in passes:
        os.makedirs(os.path.join(arguments.out, folder), exist_ok=True)
        set_sampling(scene, samples, point)
        for frame in range(first, last + 1):
            path = os.path.join(arguments.out, folder, f"{frame:04d}.exr")
            if arguments.resume and os.path.exists(path):
                continue
            jitter = cycle[(frame - first) % len(cycle)] if folder == "lr" else (0, 0)
            render_frame(scene, frame, size, jitter, path)
            print(f"{folder} {frame} of {first}:{last}", flush=True)
    write_manifest(
        arguments.out, manifest_of(arguments, scene, (output, render), (first, last), layer)
    )
    print(f"{os.path.join(arguments.out, 'sequence.json')}: {last - first + 1} frames", flush=True)


if __name__ == "__main__":
    try:
        export(parse_arguments())
    except (ExportError, OSError, RuntimeError) as wrong:
        print(f"export_sequence: {wrong}", file=sys.stderr)
        sys.exit(2)
