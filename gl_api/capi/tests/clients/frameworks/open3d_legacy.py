"""Open3D's legacy visualizer, which draws without a display by EGL: a lit mesh with its wireframe, a textured box, a
cloud of points, lines. Writes the picture as PPM: open3d_legacy.py OUT."""

import sys

import numpy as np
import open3d
import ppm

SIZE = (320, 240)


def meshes():
    torus = open3d.geometry.TriangleMesh.create_torus(1.0, 0.35, 40, 24)
    torus.compute_vertex_normals()
    places = np.asarray(torus.vertices)
    torus.vertex_colors = open3d.utility.Vector3dVector(places / (2.0 * abs(places).max()) + 0.5)
    box = open3d.geometry.TriangleMesh.create_box(0.9, 0.9, 0.9, create_uv_map=True)
    box.compute_vertex_normals()
    at = np.arange(64)
    board = np.zeros((64, 64, 3), np.uint8)
    board[..., 0] = 255 * (((at[:, None] >> 3) + (at >> 3)) & 1)
    board[..., 1] = 4 * at
    board[..., 2] = 4 * at[:, None]
    box.textures = [open3d.geometry.Image(board)]
    box.triangle_material_ids = open3d.utility.IntVector([0] * len(box.triangles))
    box.translate((-0.45, -0.45, -0.45))
    return [torus, box]


def cloud():
    turns = np.linspace(0.0, 60.0, 1500)
    places = np.stack([np.cos(turns), np.sin(turns), turns / 20.0 - 1.5], 1) * 1.5
    points = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(places))
    points.colors = open3d.utility.Vector3dVector(np.stack([turns / 60.0, 1.0 - turns / 60.0, turns * 0.0], 1))
    return points


def main(out):
    visualizer = open3d.visualization.Visualizer()
    assert visualizer.create_window(width=SIZE[0], height=SIZE[1], visible=False)
    frame = open3d.geometry.TriangleMesh.create_coordinate_frame(1.2)
    lines = open3d.geometry.LineSet.create_from_axis_aligned_bounding_box(frame.get_axis_aligned_bounding_box())
    for geometry in [*meshes(), cloud(), frame, lines]:
        visualizer.add_geometry(geometry)
    options = visualizer.get_render_option()
    options.background_color = np.array([0.2, 0.3, 0.4])
    options.point_size = 3.0
    options.mesh_show_wireframe = True
    view = visualizer.get_view_control()
    view.set_front((0.5, -0.7, 0.5))
    view.set_up((0.0, 0.0, 1.0))
    picture = np.asarray(visualizer.capture_screen_float_buffer(True))
    ppm.write(out, *SIZE, (picture * 255.0 + 0.5).astype(np.uint8).tobytes())
    visualizer.destroy_window()


main(sys.argv[1])
