"""wgpu on its GL backend: WGSL, uniform and vertex buffers, a mipmapped texture, instances, depth, four samples a
pixel. Writes the picture as PPM: wgpu_gl.py OUT."""

import math
import struct
import sys

import ppm
import wgpu

SIZE = (320, 240)
SHADER = """
struct Look { view: mat4x4<f32>, light: vec4<f32> };
@group(0) @binding(0) var<uniform> look: Look;
@group(0) @binding(1) var wood: texture_2d<f32>;
@group(0) @binding(2) var smooth_sampler: sampler;
struct Out { @builtin(position) at: vec4<f32>, @location(0) st: vec2<f32>, @location(1) shade: f32 };
@vertex fn vs(@location(0) place: vec3<f32>, @location(1) st: vec2<f32>, @location(2) normal: vec3<f32>,
              @builtin(instance_index) which: u32) -> Out {
    let x = f32(which % 4u) - 1.5;
    let z = f32(which / 4u) - 1.5;
    var out: Out;
    out.at = look.view * vec4<f32>(place * 0.35 + vec3<f32>(x, 0.0, z), 1.0);
    out.st = st * 2.0;
    out.shade = max(dot(normal, look.light.xyz), 0.0) * 0.8 + 0.2;
    return out;
}
@fragment fn fs(in: Out) -> @location(0) vec4<f32> {
    let texel = textureSample(wood, smooth_sampler, in.st);
    return vec4<f32>(texel.rgb * in.shade, 1.0);
}
"""


def cube():
    """Vertices of 8 floats, six faces of two triangles."""
    words = []
    for axis in range(3):
        for side in (-1.0, 1.0):
            for u, v in ((0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)):
                place = [0.0, 0.0, 0.0]
                place[axis] = side
                place[(axis + 1) % 3] = 2.0 * u - 1.0
                place[(axis + 2) % 3] = 2.0 * v - 1.0
                normal = [0.0, 0.0, 0.0]
                normal[axis] = side
                words += place + [float(u), float(v)] + normal
    return words


def product(a, b):
    """a × b, matrices by rows."""
    return [[sum(a[r][k] * b[k][c] for k in range(4)) for c in range(4)] for r in range(4)]


def view():
    """A camera above, as the columns of a matrix."""
    turn, tilt = 0.5, 0.6
    yaw = [[math.cos(turn), 0, -math.sin(turn), 0], [0, 1, 0, 0],
           [math.sin(turn), 0, math.cos(turn), 0], [0, 0, 0, 1]]
    pitch = [[1, 0, 0, 0], [0, math.cos(tilt), -math.sin(tilt), 0],
             [0, math.sin(tilt), math.cos(tilt), 0], [0, 0, 0, 1]]
    away = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -5.5], [0, 0, 0, 1]]
    near, far, scale = 1.0, 20.0, 1.9
    lens = [[scale * SIZE[1] / SIZE[0], 0, 0, 0], [0, scale, 0, 0],
            [0, 0, far / (near - far), near * far / (near - far)], [0, 0, -1, 0]]
    rows = product(product(lens, away), product(pitch, yaw))
    return [rows[r][c] for c in range(4) for r in range(4)]


def texture(device):
    """Checkers of 32 texels, each level half of the one before."""
    made = device.create_texture(
        size=(32, 32, 1), mip_level_count=6, format="rgba8unorm",
        usage=wgpu.TextureUsage.TEXTURE_BINDING | wgpu.TextureUsage.COPY_DST)
    for level in range(6):
        side = 32 >> level
        texels = bytearray()
        for y in range(side):
            for x in range(side):
                light = 255 if ((x << level) // 8 + (y << level) // 8) % 2 else 90
                texels += bytes((light, light * 3 // 4, 40 * level, 255))
        device.queue.write_texture(
            {"texture": made, "mip_level": level}, bytes(texels), {"bytes_per_row": 4 * side}, (side, side, 1))
    return made


def pipeline(device):
    module = device.create_shader_module(code=SHADER)
    attributes = [
        {"format": "float32x3", "offset": 0, "shader_location": 0},
        {"format": "float32x2", "offset": 12, "shader_location": 1},
        {"format": "float32x3", "offset": 20, "shader_location": 2},
    ]
    return device.create_render_pipeline(
        layout="auto",
        vertex={"module": module, "entry_point": "vs",
                "buffers": [{"array_stride": 32, "step_mode": "vertex", "attributes": attributes}]},
        primitive={"topology": "triangle-list", "cull_mode": "none"},
        depth_stencil={"format": "depth24plus", "depth_write_enabled": True, "depth_compare": "less"},
        multisample={"count": 4},
        fragment={"module": module, "entry_point": "fs", "targets": [{"format": "rgba8unorm"}]})


def main(out):
    found = [a for a in wgpu.gpu.enumerate_adapters_sync() if a.info["backend_type"] == "OpenGL"]
    assert found, "no adapter of OpenGL"
    device = found[0].request_device_sync()
    attachment = wgpu.TextureUsage.RENDER_ATTACHMENT
    size = (*SIZE, 1)
    samples = device.create_texture(size=size, sample_count=4, format="rgba8unorm", usage=attachment)
    depth = device.create_texture(size=size, sample_count=4, format="depth24plus", usage=attachment)
    target = device.create_texture(size=size, format="rgba8unorm", usage=attachment | wgpu.TextureUsage.COPY_SRC)
    drawn = pipeline(device)
    words = cube()
    vertices = device.create_buffer_with_data(
        data=struct.pack(f"{len(words)}f", *words), usage=wgpu.BufferUsage.VERTEX)
    look = device.create_buffer_with_data(
        data=struct.pack("20f", *view(), 0.48, 0.8, 0.36, 0.0), usage=wgpu.BufferUsage.UNIFORM)
    sampler = device.create_sampler(
        mag_filter="linear", min_filter="linear", mipmap_filter="linear",
        address_mode_u="repeat", address_mode_v="repeat")
    bound = device.create_bind_group(layout=drawn.get_bind_group_layout(0), entries=[
        {"binding": 0, "resource": {"buffer": look, "offset": 0, "size": 80}},
        {"binding": 1, "resource": texture(device).create_view()},
        {"binding": 2, "resource": sampler}])
    commands = device.create_command_encoder()
    render = commands.begin_render_pass(
        color_attachments=[{"view": samples.create_view(), "resolve_target": target.create_view(),
                            "clear_value": (0.1, 0.15, 0.25, 1.0), "load_op": "clear", "store_op": "store"}],
        depth_stencil_attachment={"view": depth.create_view(), "depth_clear_value": 1.0,
                                  "depth_load_op": "clear", "depth_store_op": "store"})
    render.set_pipeline(drawn)
    render.set_vertex_buffer(0, vertices)
    render.set_bind_group(0, bound)
    render.draw(36, 16)
    render.end()
    device.queue.submit([commands.finish()])
    rows = device.queue.read_texture(
        {"texture": target}, {"bytes_per_row": 4 * SIZE[0], "rows_per_image": SIZE[1]}, size)
    rows = bytes(rows)
    ppm.write(out, *SIZE, b"".join(rows[at:at + 3] for at in range(0, len(rows), 4)))


main(sys.argv[1])
