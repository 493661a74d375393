"""MuJoCo's own renderer: a checkered floor that reflects, a cube-mapped box, a sky box, and two
lights that cast shadows. Writes the picture as PPM: mujoco_scene.py OUT WIDTH HEIGHT.

MUJOCO_GL says how it gets its context: egl or osmesa."""

import sys

SCENE = """
<mujoco>
  <visual>
    <global offwidth="1024" offheight="1024"/>
    <quality shadowsize="1024" offsamples="{samples}"/>
  </visual>
  <asset>
    <texture name="sky" type="skybox" builtin="gradient" rgb1="0.3 0.5 0.7" rgb2="0 0 0.1"
             width="64" height="384"/>
    <texture name="floor" type="2d" builtin="checker" rgb1="0.2 0.3 0.4" rgb2="0.8 0.8 0.7"
             width="256" height="256"/>
    <texture name="box" type="cube" builtin="checker" mark="cross" rgb1="0.8 0.3 0.1"
             rgb2="0.1 0.6 0.3" markrgb="1 1 1" width="64" height="64"/>
    <material name="floor" texture="floor" texrepeat="6 6" reflectance="0.35"/>
    <material name="box" texture="box"/>
    <material name="shiny" rgba="0.7 0.2 0.6 1" specular="0.9" shininess="0.8"/>
  </asset>
  <worldbody>
    <light pos="1.5 -1.5 3" dir="-0.45 0.45 -0.9" diffuse="0.6 0.6 0.55" castshadow="true"/>
    <light pos="-2 -1 2.5" dir="0.6 0.3 -0.75" diffuse="0.4 0.4 0.5" castshadow="true"/>
    <geom type="plane" size="3 3 0.1" material="floor"/>
    <geom type="box" size="0.35 0.35 0.35" pos="0.1 0 0.4" euler="0 0 30" material="box"/>
    <geom type="sphere" size="0.3" pos="-0.9 0.3 0.32" material="shiny"/>
    <geom type="capsule" size="0.12 0.3" pos="0.95 0.4 0.45" rgba="0.2 0.6 0.8 1"/>
    <geom type="cylinder" size="0.2 0.25" pos="0.3 -0.9 0.28" rgba="0.9 0.8 0.2 0.6"/>
    <camera name="eye" pos="0 -3.4 1.7" xyaxes="1 0 0 0 0.4 0.92"/>
  </worldbody>
</mujoco>
"""


def main(out, width, height, samples="0"):
    import mujoco

    model = mujoco.MjModel.from_xml_string(SCENE.format(samples=samples))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, int(height), int(width)) as renderer:
        renderer.update_scene(data, camera="eye")
        pixels = renderer.render()
    with open(out, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (pixels.shape[1], pixels.shape[0]))
        file.write(pixels.tobytes())


main(*sys.argv[1:])
