"""PyVista offscreen: a sphere with its edges and ambient occlusion in screen space. Writes the picture as PPM:
pyvista_ssao.py OUT."""

import sys

import numpy as np
import ppm
import pyvista

SIZE = (320, 240)


def main(out):
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    plotter.add_mesh(pyvista.Sphere(), color="tan", show_edges=True)
    plotter.enable_ssao()
    picture = plotter.screenshot(return_img=True)
    ppm.write(out, *SIZE, np.ascontiguousarray(picture[..., :3]).tobytes())


main(sys.argv[1])
