"""A lit sphere of GLU's in a window of pygame's. Writes the picture as PPM:
pygame_sphere.py OUT."""

import sys

import ppm

SIZE = (320, 240)


def main(out):
    import pygame
    from OpenGL import GL as gl
    from OpenGL import GLU as glu

    pygame.display.init()
    pygame.display.set_mode(SIZE, pygame.OPENGL | pygame.DOUBLEBUF)
    gl.glViewport(0, 0, *SIZE)
    gl.glClearColor(0.1, 0.2, 0.3, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    glu.gluPerspective(45, SIZE[0] / SIZE[1], 0.1, 50)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glTranslatef(0, 0, -5)
    gl.glRotatef(30, 1, 1, 0)
    for what in (gl.GL_DEPTH_TEST, gl.GL_LIGHTING, gl.GL_LIGHT0):
        gl.glEnable(what)
    glu.gluSphere(glu.gluNewQuadric(), 1.2, 24, 24)
    rows = gl.glReadPixels(0, 0, *SIZE, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE)
    pygame.display.flip()
    ppm.write(out, *SIZE, ppm.from_below(rows, SIZE[0], 4))


main(*sys.argv[1:])
