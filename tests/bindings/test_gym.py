"""The environment of Gymnasium passes its checker. Debian has no gymnasium; the soak has that of PyPI."""

from __future__ import annotations

import unittest

import numpy as np

from beside import ROOT

try:
    import gymnasium
    from gymnasium.utils.env_checker import check_env
except ImportError as error:
    reason = "gymnasium is not installed (Debian has none; packaging/soak takes that of PyPI), so the environment was not checked"
    raise unittest.SkipTest(reason) from error

from underact.gym import ConstraintEnv

CIRCLE = ROOT / "scenes/05_circle.json"


class Environment(unittest.TestCase):
    def test_gymnasium_finds_nothing_wrong(self):
        check_env(ConstraintEnv(CIRCLE, steps=20), skip_render_check=True)

    def test_a_hand_that_goes_to_its_target_is_rewarded(self):
        env = gymnasium.make("underact/Constraint-v0", scene=CIRCLE, steps=30)
        seen, _ = env.reset(seed=3)
        done, rewards = False, []
        while not done:
            seen, reward, terminated, truncated, info = env.step(np.clip(seen[6:9] / 2.0, -1, 1))  # towards the target
            rewards.append(reward)
            done = terminated or truncated
        self.assertEqual(len(rewards), 30)
        self.assertGreater(rewards[-1], rewards[0])
        self.assertEqual(info["state"].mode, "running")

    def test_a_seed_makes_the_same_episode(self):
        def episode(seed):
            env = ConstraintEnv(CIRCLE, steps=5)
            first, _ = env.reset(seed=seed)
            return np.array([first] + [env.step([0.5, -0.5, 0.1])[0] for _ in range(5)])

        self.assertTrue((episode(1) == episode(1)).all())
        self.assertFalse((episode(1) == episode(2)).all())


if __name__ == "__main__":
    unittest.main()
