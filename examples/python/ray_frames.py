"""A batch of MuJoCo's frames on several processes, by Ray (`pip install ray`): the digest of each frame is that of one
process and one thread. ray_frames.py [FRAMES [PROCESSES]]"""

import os
import sys

import ray

# Read when the first context is made.
os.environ["DETGL_THREADS"] = "1"


def draw(number):
    # Where it draws, before mujoco is imported: mujoco_frame calls detgl.use().
    import detgl
    import mujoco_frame

    return detgl.digest(mujoco_frame.draw(160, 120, steps=20 * number))


@ray.remote
def frame(number):
    digest = draw(number)
    import detgl

    return digest, os.getpid(), detgl.info()["threads"]


def main(frames=8, processes=2):
    expected = [draw(number) for number in range(frames)]
    assert len(set(expected)) == frames, "no two frames are the same"
    ray.init(num_cpus=processes, include_dashboard=False, logging_level="error")
    for threads in (1, 3):
        # The functions of this folder are there for the processes of Ray.
        environment = {"env_vars": {"PYTHONPATH": sys.path[0], "DETGL_THREADS": str(threads)}}
        remote = frame.options(runtime_env=environment)
        done = ray.get([remote.remote(number) for number in range(frames)])
        assert [digest for digest, _, _ in done] == expected
        assert all(found == threads for _, _, found in done)
        count = len({process for _, process, _ in done})
        print(f"{frames} frames by {count} other processes of {threads} threads: the digests of this one")
    ray.shutdown()


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
