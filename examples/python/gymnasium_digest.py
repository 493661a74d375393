"""Prints one number for the pictures of 100 steps of a gymnasium environment: the same for every number of threads and
every instruction set, so a test may compare it. gymnasium_digest.py [ENVIRONMENT]"""

import hashlib
import sys

import detgl

detgl.use()

import gymnasium  # noqa: E402

STEPS = 100


def digest(name):
    environment = gymnasium.make(name, render_mode="rgb_array", width=128, height=128)
    environment.action_space.seed(1)
    environment.reset(seed=1)
    sha = hashlib.sha256()
    for _ in range(STEPS):
        _, _, terminated, truncated, _ = environment.step(environment.action_space.sample())
        sha.update(detgl.digest(environment.render()).encode())
        if terminated or truncated:
            environment.reset(seed=1)
    environment.close()
    return sha.hexdigest()


if __name__ == "__main__":
    print(digest(*(sys.argv[1:] or ["InvertedDoublePendulum-v5"])))
