"""Skia's GL backend: gradients, blur, paths and blending on a GPU surface. Writes the picture as PPM:
skia_surface.py OUT."""

import sys

import moderngl
import ppm
import skia

SIZE = (320, 240)


def scene(canvas):
    canvas.clear(skia.ColorSetRGB(240, 236, 226))
    colors = [skia.ColorSetRGB(200, 60, 40), skia.ColorSetRGB(250, 210, 80), skia.ColorSetRGB(40, 90, 180)]
    shader = skia.GradientShader.MakeLinear(points=[(20, 20), (200, 160)], colors=colors)
    canvas.drawRoundRect(skia.Rect(20, 20, 200, 160), 24, 24, skia.Paint(Shader=shader, AntiAlias=True))
    around = skia.GradientShader.MakeRadial(center=(220, 130), radius=80, colors=colors[::-1])
    canvas.drawCircle(220, 130, 70, skia.Paint(Shader=around, AntiAlias=True, Alphaf=0.7))
    blurred = skia.MaskFilter.MakeBlur(skia.kNormal_BlurStyle, 6.0)
    canvas.drawRect(skia.Rect(60, 170, 180, 220), skia.Paint(Color=0xFF304060, MaskFilter=blurred))
    star = skia.Path()
    star.moveTo(250, 20)
    for x, y in ((285, 100), (205, 45), (300, 45), (220, 100)):
        star.lineTo(x, y)
    star.close()
    canvas.drawPath(star, skia.Paint(Color=0xFF208050, AntiAlias=True, BlendMode=skia.BlendMode.kMultiply))
    canvas.drawLine(10, 230, 310, 190, skia.Paint(Color=0xFF000000, AntiAlias=True, StrokeWidth=3))
    canvas.save()
    canvas.rotate(20, 120, 90)
    canvas.drawArc(
        skia.Rect(80, 60, 160, 120), 30, 250, False,
        skia.Paint(Color=0xFFFFFFFF, AntiAlias=True, Style=skia.Paint.kStroke_Style, StrokeWidth=8))
    canvas.restore()


def main(out):
    context = moderngl.create_standalone_context(backend="egl")
    skias = skia.GrDirectContext.MakeGL(skia.GrGLInterface.MakeEGL())
    assert skias, "Skia takes no context"
    info = skia.ImageInfo.MakeN32Premul(*SIZE)
    surface = skia.Surface.MakeRenderTarget(skias, skia.Budgeted.kNo, info)
    assert surface, "Skia makes no surface"
    scene(surface.getCanvas())
    surface.flushAndSubmit()
    rows = surface.toarray(colorType=skia.kRGBA_8888_ColorType).tobytes()
    assert context.error == "GL_NO_ERROR"
    ppm.write(out, *SIZE, b"".join(rows[at:at + 3] for at in range(0, len(rows), 4)))


main(sys.argv[1])
