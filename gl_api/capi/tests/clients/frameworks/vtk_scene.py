"""VTK on its own EGL window: glyphs, transparent surfaces by depth peeling, and a volume through a 3D texture. Writes
the picture as PPM: vtk_scene.py OUT."""

import sys

import ppm
import vtk
from vtk.util.numpy_support import vtk_to_numpy

SIZE = (320, 240)


def surface(source, color, opacity):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def glyphs():
    points = vtk.vtkPlaneSource()
    points.SetResolution(6, 6)
    points.SetOrigin(-2, -1.5, -1)
    points.SetPoint1(2, -1.5, -1)
    points.SetPoint2(-2, -1.5, 1.5)
    ball = vtk.vtkSphereSource()
    ball.SetRadius(0.12)
    mapper = vtk.vtkGlyph3DMapper()
    mapper.SetInputConnection(points.GetOutputPort())
    mapper.SetSourceConnection(ball.GetOutputPort())
    mapper.ScalingOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def volume():
    wave = vtk.vtkRTAnalyticSource()
    wave.SetWholeExtent(-10, 10, -10, 10, -10, 10)
    mapper = vtk.vtkGPUVolumeRayCastMapper()
    mapper.SetInputConnection(wave.GetOutputPort())
    mapper.SetAutoAdjustSampleDistances(0)
    mapper.SetSampleDistance(0.5)
    mapper.UseJitteringOff()
    color, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    color.AddRGBPoint(40, 0.1, 0.2, 0.9)
    color.AddRGBPoint(270, 1.0, 0.6, 0.1)
    opacity.AddPoint(120, 0.0)
    opacity.AddPoint(270, 0.4)
    drawn = vtk.vtkVolume()
    drawn.SetMapper(mapper)
    drawn.GetProperty().SetColor(color)
    drawn.GetProperty().SetScalarOpacity(opacity)
    drawn.GetProperty().SetInterpolationTypeToLinear()
    drawn.SetScale(0.08)
    drawn.SetPosition(1.0, 0.6, 0)
    return drawn


def main(out):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.2, 0.3, 0.4)
    renderer.SetUseDepthPeeling(1)
    renderer.SetMaximumNumberOfPeels(8)
    window = vtk.vtkEGLRenderWindow()
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    cone, ball = vtk.vtkConeSource(), vtk.vtkSphereSource()
    cone.SetResolution(40)
    ball.SetThetaResolution(30)
    ball.SetPhiResolution(30)
    inner = surface(cone, (0.9, 0.3, 0.2), 1.0)
    inner.SetPosition(-1.0, 0.5, 0)
    outer = surface(ball, (0.2, 0.9, 0.4), 0.4)
    outer.SetScale(1.6)
    outer.SetPosition(-1.0, 0.5, 0)
    for actor in (inner, outer, glyphs()):
        renderer.AddActor(actor)
    renderer.AddVolume(volume())
    renderer.GetActiveCamera().SetPosition(0, 0.5, 6)
    renderer.ResetCameraClippingRange()
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    rows = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    ppm.write(out, *SIZE, ppm.from_below(rows.tobytes(), SIZE[0], 3))


main(sys.argv[1])
