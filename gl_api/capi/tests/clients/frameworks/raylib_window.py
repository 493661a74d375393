"""raylib's OpenGL 3.3 backend in a window of GLFW's null platform: meshes, a shader of one's own, a render texture, text
and shapes. Writes the picture as PPM: raylib_window.py OUT."""

import sys

import ppm
from raylib import ffi, rl

SIZE = (320, 240)
GLFW_PLATFORM, GLFW_PLATFORM_NULL = 0x00050003, 0x00060005
FRAGMENT = b"""#version 330
in vec2 fragTexCoord;
in vec4 fragColor;
uniform sampler2D texture0;
uniform vec4 colDiffuse;
out vec4 finalColor;
void main() {
    vec4 texel = texture(texture0, fragTexCoord) * colDiffuse * fragColor;
    finalColor = vec4(texel.rgb * (0.4 + 0.6 * fragTexCoord.y), texel.a);
}"""


def look():
    camera = ffi.new("struct Camera3D *")
    camera.position = (4.0, 3.0, 5.0)
    camera.target = (0.0, 0.5, 0.0)
    camera.up = (0.0, 1.0, 0.0)
    camera.fovy = 45.0
    return camera[0]


def scene(model, screen):
    rl.ClearBackground((30, 40, 60, 255))
    rl.BeginMode3D(look())
    rl.DrawGrid(10, 1.0)
    rl.DrawModel(model, (0.0, 0.5, 0.0), 1.0, (255, 255, 255, 255))
    rl.DrawSphere((-1.5, 0.5, 0.0), 0.5, (230, 60, 60, 255))
    rl.DrawCylinder((1.5, 0.0, 0.5), 0.2, 0.5, 1.2, 16, (60, 200, 90, 160))
    rl.EndMode3D()
    # Upside down, as render textures are.
    rl.DrawTexturePro(screen.texture, (0, 0, 64, -64), (240, 10, 72, 72), (0, 0), 0.0, (255, 255, 255, 255))
    rl.DrawText(b"raylib on DetGL", 10, 10, 20, (255, 220, 120, 255))
    rl.DrawCircleGradient((60, 200), 30.0, (255, 200, 0, 255), (120, 0, 160, 255))
    rl.DrawRectangleRounded((110, 180, 80, 40), 0.5, 8, (80, 160, 240, 200))


def main(out):
    rl.SetTraceLogLevel(rl.LOG_WARNING)
    rl.glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_NULL)
    rl.InitWindow(*SIZE, b"scene")
    assert rl.IsWindowReady()
    model = rl.LoadModelFromMesh(rl.GenMeshTorus(0.4, 1.6, 16, 32))
    checked = rl.GenImageChecked(64, 64, 8, 8, (255, 255, 255, 255), (90, 110, 200, 255))
    texture = ffi.new("Texture2D *", rl.LoadTextureFromImage(checked))
    rl.GenTextureMipmaps(texture)
    rl.SetTextureFilter(texture[0], rl.TEXTURE_FILTER_TRILINEAR)
    rl.SetMaterialTexture(model.materials, rl.MATERIAL_MAP_ALBEDO, texture[0])
    shader = rl.LoadShaderFromMemory(ffi.NULL, FRAGMENT)
    assert rl.IsShaderValid(shader)
    model.materials[0].shader = shader
    screen = rl.LoadRenderTexture(64, 64)
    rl.BeginTextureMode(screen)
    rl.ClearBackground((250, 250, 250, 255))
    rl.DrawTriangle((32, 4), (4, 60), (60, 60), (200, 30, 90, 255))
    rl.EndTextureMode()
    rl.BeginDrawing()
    scene(model, screen)
    rl.rlDrawRenderBatchActive()
    rows = ffi.buffer(rl.rlReadScreenPixels(*SIZE), 4 * SIZE[0] * SIZE[1])[:]
    rl.EndDrawing()
    ppm.write(out, *SIZE, b"".join(rows[at:at + 3] for at in range(0, len(rows), 4)))


main(sys.argv[1])
