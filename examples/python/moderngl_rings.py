"""ModernGL, which asks for OpenGL 3.3, core: instances, a uniform block and a fragment shader.

moderngl_rings.py OUT.png"""

import struct
import sys

import detgl

detgl.use()

import moderngl  # noqa: E402
from detgl import golden  # noqa: E402

SIZE = (240, 180)
VERTEX = """#version 330
layout(std140) uniform Look { vec4 tint[3]; };
in vec2 corner;
out vec2 place;
flat out vec4 color;
void main() {
    place = corner;
    color = tint[gl_InstanceID];
    gl_Position = vec4(corner * 0.45 + vec2(float(gl_InstanceID - 1) * 0.5, 0.1 * float(gl_InstanceID)), 0.0, 1.0);
}"""
FRAGMENT = """#version 330
in vec2 place;
flat in vec4 color;
layout(location = 0) out vec4 result;
void main() {
    float radius = length(place);
    if (radius > 1.0) discard;
    result = vec4(color.rgb * (0.6 + 0.4 * sin(24.0 * radius)), 1.0);
}"""


def draw():
    context = moderngl.create_context(standalone=True, backend="egl", require=330)
    program = context.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT)
    look = context.buffer(struct.pack("12f", 1, 0.8, 0.3, 1, 0.3, 0.8, 1, 1, 0.9, 0.4, 0.7, 1))
    look.bind_to_uniform_block(0)
    program["Look"].binding = 0
    corners = context.buffer(struct.pack("8f", -1, -1, 1, -1, -1, 1, 1, 1))
    array = context.vertex_array(program, [(corners, "2f", "corner")])
    target = context.simple_framebuffer(SIZE)
    target.use()
    target.clear(0.05, 0.05, 0.1, 1.0)
    array.render(moderngl.TRIANGLE_STRIP, instances=3)
    rows = target.read(components=3, alignment=1)
    context.release()
    # The rows from the top.
    width = 3 * SIZE[0]
    rows = b"".join(rows[at:at + width] for at in range(len(rows) - width, -1, -width))
    return memoryview(rows).cast("B", (SIZE[1], SIZE[0], 3))


if __name__ == "__main__":
    golden.write_png(sys.argv[1], draw())
