"""A frame of MuJoCo, without a display: mujoco_frame.py OUT.png"""

import sys

import detgl

detgl.use()

import mujoco  # noqa: E402
from detgl import golden  # noqa: E402

SCENE = """
<mujoco>
  <asset>
    <texture name="sky" type="skybox" builtin="gradient" rgb1=".3 .5 .7" rgb2="0 0 .1" width="64" height="384"/>
    <texture name="floor" type="2d" builtin="checker" rgb1=".2 .3 .4" rgb2=".8 .8 .7" width="256" height="256"/>
    <material name="floor" texture="floor" texrepeat="6 6" reflectance=".3"/>
  </asset>
  <worldbody>
    <light pos="1 -1 3" dir="-.3 .3 -1"/>
    <geom type="plane" size="3 3 .1" material="floor"/>
    <body pos="0 0 1.5" euler="20 30 10">
      <freejoint/>
      <geom type="box" size=".3 .3 .3" rgba=".8 .3 .1 1"/>
    </body>
    <geom type="sphere" size=".3" pos="-.9 .3 .3" rgba=".2 .6 .8 1"/>
  </worldbody>
</mujoco>
"""


def draw(width=320, height=240, steps=200):
    model = mujoco.MjModel.from_xml_string(SCENE)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, steps)
    with mujoco.Renderer(model, height, width) as renderer:
        renderer.update_scene(data)
        return renderer.render()


if __name__ == "__main__":
    picture = draw()
    golden.write_png(sys.argv[1], picture)
    print(detgl.digest(picture))
