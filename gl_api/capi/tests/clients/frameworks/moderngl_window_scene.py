"""moderngl-window without a window, with what ModernGL's examples show: particles moved by transform feedback, outlines
of culled faces over a uniform block and sources that include others, integer attributes, blending, a quad over
the whole window that fetches another framebuffer. Writes the picture as PPM: moderngl_window_scene.py OUT."""

import struct
import sys

import moderngl
import moderngl_window
import numpy as np
import ppm
from moderngl_window import geometry
from moderngl_window.conf import settings

SIZE = (320, 240)
COMMON = """
struct Lamp { vec4 place; vec4 color; float power; };
layout(std140) uniform Common { mat4 camera; vec4 eye; Lamp lamps[2]; };
"""
LIT_VERTEX = """#version 330
#include "common"
uniform vec3 offset;
uniform float scale;
in vec3 in_position;
in vec3 in_normal;
out vec3 place;
out vec3 normal;
void main() {
    place = offset + in_position * scale;
    normal = in_normal;
    gl_Position = camera * vec4(place, 1.0);
}"""
LIT_FRAGMENT = """#version 330
#include "common"
uniform vec3 color;
in vec3 place;
in vec3 normal;
out vec4 lit;
void main() {
    vec3 sum = 0.05 * color;
    for (int i = 0; i < lamps.length(); i++) {
        vec3 to = lamps[i].place.xyz - place;
        vec3 middle = normalize(normalize(to) + normalize(eye.xyz - place));
        float light = lamps[i].power / dot(to, to);
        sum += light * lamps[i].color.rgb * (color * max(dot(normalize(to), normal), 0.0)
            + pow(max(dot(middle, normal), 0.0), 16.0));
    }
    lit = vec4(pow(sum, vec3(1.0 / 2.2)), 1.0);
}"""
FLAT_FRAGMENT = """#version 330
uniform vec3 color;
out vec4 flat_color;
void main() { flat_color = vec4(color, 1.0); }"""
MOVE = """#version 330
uniform vec2 pull;
in vec2 from;
in float life;
in vec2 speed;
out vec2 to;
out float left;
out vec2 then;
void main() {
    bool is_over = life <= 0.0 || any(greaterThan(abs(from), vec2(1.0)));
    to = is_over ? vec2(0.0) : from + speed + pull;
    left = is_over ? 1.0 : life - 0.02;
    then = is_over ? -speed : speed * 0.98;
}"""
POINT_VERTEX = """#version 330
in vec2 from;
in float life;
out float size;
void main() { size = life; gl_Position = vec4(from, 0.0, 1.0); }"""
POINT_FRAGMENT = """#version 330
in float size;
out vec4 color;
void main() {
    float from_middle = distance(gl_PointCoord, vec2(0.5));
    if (from_middle > size * 0.5) discard;
    color = vec4(1.0 - vec3(from_middle), 1.0) * vec4(0.98, 0.95, 0.72, 1.0);
}"""
LABEL_VERTEX = """#version 330
in vec2 corner;
in uint label;
flat out uint value;
void main() { gl_Position = vec4(corner, 0.0, 1.0); value = label; }"""
LABEL_FRAGMENT = """#version 330
flat in uint value;
out vec4 color;
void main() { color = vec4(float(value) / 16.0, 0.0, float(value) / 16.0, 1.0); }"""
SCREEN_FRAGMENT = """#version 330
uniform sampler2D picture;
out vec4 color;
void main() { color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }"""
SCREEN_VERTEX = """#version 330
in vec3 in_position;
void main() { gl_Position = vec4(in_position, 1.0); }"""


def camera(aspect):
    near, far = 0.1, 100.0
    project = np.zeros((4, 4))
    project[0, 0], project[1, 1] = 2.0 / aspect, 2.0
    project[2, 2], project[2, 3] = (far + near) / (near - far), 2.0 * far * near / (near - far)
    project[3, 2] = -1.0
    view = np.eye(4)
    a, b = 0.6, 0.5
    turn = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    lean = np.array([[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]])
    view[:3, :3] = lean @ turn
    view[2, 3] = -5.0
    eye = -view[:3, :3].T @ view[:3, 3]
    return (project @ view).T.astype("f4").tobytes() + struct.pack("4f", *eye, 1.0)


def outlines(context):
    common = camera(SIZE[0] / SIZE[1])
    for place, color, power in [((1, 2, 3), (1, 1, 1), 6.0), ((-3, 1, 2), (0.4, 0.6, 1), 8.0)]:
        common += struct.pack("4f4ff12x", *place, 1.0, *color, 1.0, power)
    context.buffer(common).bind_to_uniform_block(0)
    lit = context.program(vertex_shader=LIT_VERTEX, fragment_shader=LIT_FRAGMENT)
    flat = context.program(vertex_shader=LIT_VERTEX, fragment_shader=FLAT_FRAGMENT)
    lit["Common"].binding = flat["Common"].binding = 0
    bodies = [(geometry.cube(size=(1.2, 1.2, 1.2)), (-1.0, 0.0, 0.0), (1.0, 0.4, 0.2)),
              (geometry.sphere(0.8, 32, 16), (0.9, 0.2, 0.0), (0.2, 0.8, 0.4))]
    context.enable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
    for program, scale, culled in [(lit, 1.0, "back"), (flat, 1.08, "front")]:
        context.cull_face = culled
        for body, offset, color in bodies:
            program["offset"], program["scale"] = offset, scale
            program["color"] = color if program is lit else (1.0, 1.0, 1.0)
            body.render(program)
    context.enable_only(moderngl.NOTHING)


def particles(context, count=400):
    turns = np.arange(count) * 2.399963
    speed = 0.004 + 0.016 * np.arange(count) / count
    first = np.zeros((count, 5), "f4")
    first[:, 2] = 1.0
    first[:, 3], first[:, 4] = speed * np.cos(turns), speed * np.sin(turns)
    now, after = context.buffer(first), context.buffer(reserve=first.nbytes)
    move = context.program(vertex_shader=MOVE, varyings=["to", "left", "then"])
    move["pull"] = (0.0, -0.002)
    mover = context.vertex_array(move, [(now, "2f 1f 2f", "from", "life", "speed")])
    for _ in range(25):
        mover.transform(after, moderngl.POINTS, count)
        context.copy_buffer(now, after)
    show = context.program(vertex_shader=POINT_VERTEX, fragment_shader=POINT_FRAGMENT)
    context.point_size = 12.0
    context.vertex_array(show, [(now, "2f 1f 2x4", "from", "life")]).render(moderngl.POINTS)


def squares(context):
    unit = np.array([0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1], "f4").reshape(-1, 2)
    corners = [0.2 * unit + (-0.95 + 0.13 * (i & 1), 0.55 + 0.13 * (i >> 1)) for i in range(4)]
    labels = np.repeat(np.array([1, 2, 4, 8], "u4"), 6)
    program = context.program(vertex_shader=LABEL_VERTEX, fragment_shader=LABEL_FRAGMENT)
    content = [(context.buffer(np.concatenate(corners).astype("f4")), "2f4", "corner"),
               (context.buffer(labels), "1u4", "label")]
    context.enable(moderngl.BLEND)
    context.blend_func = moderngl.ONE, moderngl.ONE
    context.vertex_array(program, content).render()
    context.enable_only(moderngl.NOTHING)


def main(out):
    settings.WINDOW.update({"class": "moderngl_window.context.headless.Window", "gl_version": (3, 3), "size": SIZE,
                            "backend": "egl"})
    window = moderngl_window.create_window_from_settings()
    context = window.ctx
    context.includes["common"] = COMMON
    seen = context.texture(SIZE, 3)
    target = context.framebuffer([seen], context.depth_renderbuffer(SIZE))
    target.use()
    target.clear(0.2, 0.3, 0.4)
    outlines(context)
    particles(context)
    squares(context)
    window.use()
    seen.use(0)
    geometry.quad_fs().render(context.program(vertex_shader=SCREEN_VERTEX, fragment_shader=SCREEN_FRAGMENT))
    ppm.write(out, *SIZE, ppm.from_below(window.fbo.read(components=3), SIZE[0], 3))


main(sys.argv[1])
