"""Dear ImGui's GL 3.3 renderer on a context of ModernGL: widgets, lines and circles. Writes the picture as PPM:
imgui_windows.py OUT."""

import sys

import imgui
import moderngl
import ppm
from imgui.integrations.opengl import ProgrammablePipelineRenderer

SIZE = (480, 360)


def widgets():
    imgui.set_next_window_position(20, 20)
    imgui.set_next_window_size(260, 200)
    imgui.begin("Widgets")
    imgui.text("Hello, DetGL")
    imgui.button("Press")
    imgui.slider_float("slide", 0.4, 0.0, 1.0)
    imgui.color_edit3("colour", 0.8, 0.3, 0.2)
    imgui.checkbox("tick", True)
    imgui.end()
    imgui.set_next_window_position(180, 150)
    imgui.set_next_window_size(280, 190)
    imgui.begin("Lines")
    draw = imgui.get_window_draw_list()
    for at in range(12):
        tint = imgui.get_color_u32_rgba(at / 12, 0.5, 1 - at / 12, 0.9)
        draw.add_line(190 + at * 20, 320, 440 - at * 20, 190, tint, 2.0)
        draw.add_circle(200 + at * 21, 260, 3 + at, tint, 24, 1.5)
    imgui.end()


def main(out):
    context = moderngl.create_standalone_context(backend="egl")
    target = context.simple_framebuffer(SIZE)
    target.use()
    target.clear(0.2, 0.25, 0.3, 1.0)
    imgui.create_context()
    imgui.get_io().display_size = SIZE
    imgui.get_io().ini_file_name = None
    renderer = ProgrammablePipelineRenderer()
    imgui.new_frame()
    widgets()
    imgui.render()
    renderer.render(imgui.get_draw_data())
    assert context.error == "GL_NO_ERROR"
    ppm.write(out, *SIZE, ppm.from_below(target.read(components=3), SIZE[0], 3))


main(sys.argv[1])
