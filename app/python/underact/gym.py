"""A scene as an environment of Gymnasium: a learner's hand holds the stylus, and feels the
constraint.

    import gymnasium, underact.gym
    env = gymnasium.make("underact/Constraint-v0", scene="scenes/05_circle.json")

Requires gymnasium, which is no dependency of the package.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np

from .scene import Scene, read
from .sim import Simulation, State

Observation = np.ndarray[Any, np.dtype[np.float64]]


def _nearer(state: State) -> float:
    """The reward where none is given: the tip's distance from its target, mm, negative."""
    return -state.error_mm


class ConstraintEnv(gymnasium.Env[Observation, Observation]):
    """The hand moves where it wants the tip by at most step_mm along each axis; the arm pushes
    back.

    action: (3,), from -1 to 1, shares of step_mm. observation: (12,), the tip's position (mm), its
    velocity (mm/s), the way to its target (mm; 0 where there is none) and the force sent (N), each
    within 1e6. reward: of the state after the step; by default the error in mm, negative. An
    episode is terminated by a fault and truncated after `steps`. Each begins with the hand start_mm
    or less from where the arm rests, along each axis, drawn by the seed of reset(). info: "state".
    """

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(
        self,
        scene: Scene | str | os.PathLike[str],
        *,
        reward: Callable[[State], float] = _nearer,
        ticks_per_step: int = 20,
        steps: int = 500,
        step_mm: float = 2.0,
        start_mm: float = 20.0,
        rate_hz: int = 1000,
        arm_model: str | None = None,
    ):
        if ticks_per_step < 1 or steps < 1:
            raise ValueError("ticks_per_step and steps must be 1 or more.")
        self._scene = scene if isinstance(scene, Scene) else read(scene)
        self._reward, self._ticks, self._steps = reward, ticks_per_step, steps
        self._step_mm, self._start_mm = step_mm, start_mm
        self._options: dict[str, Any] = {"rate_hz": rate_hz, "keep": False}
        if arm_model is not None:
            self._options["arm_model"] = arm_model
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (3,), np.float64)
        self.observation_space = gymnasium.spaces.Box(-1e6, 1e6, (12,), np.float64)
        self._run: Simulation | None = None
        self._wish_mm = np.zeros(3)
        self._done = 0

    def _observed(self, state: State) -> Observation:
        error_mm = np.nan_to_num(state.target_mm - state.p_mm, nan=0.0)
        seen = np.concatenate([state.p_mm, state.v_mm_per_s, error_mm, state.force_N])
        return np.clip(seen, -1e6, 1e6)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Puts the arm at its rest, and the hand near it. options: {"p_mm": (3,)}, where the hand
        is instead.
        """
        super().reset(seed=seed)
        self._run = Simulation(
            self._scene, seed=int(self.np_random.integers(2**31)), **self._options
        )
        self._run.step(1)
        rest_mm = self._run.state.p_mm
        drawn_mm = rest_mm + self.np_random.uniform(-self._start_mm, self._start_mm, 3)
        self._wish_mm = np.asanyarray((options or {}).get("p_mm", drawn_mm), dtype=float)
        self._done = 0
        self._run.want(self._wish_mm)
        self._run.step(self._ticks)
        return self._observed(self._run.state), {"state": self._run.state}

    def step(self, action: Observation) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Moves the hand's wish and runs ticks_per_step ticks."""
        if self._run is None:
            raise gymnasium.error.ResetNeeded("Call reset() before step().")
        moved = np.clip(np.asanyarray(action, dtype=float), -1.0, 1.0)
        self._wish_mm = self._wish_mm + self._step_mm * moved
        self._run.want(self._wish_mm)
        self._run.step(self._ticks)
        self._done += 1
        state = self._run.state
        terminated, truncated = state.mode == "fault", self._done >= self._steps
        return (
            self._observed(state),
            float(self._reward(state)),
            terminated,
            truncated,
            {"state": state},
        )

    def close(self) -> None:
        """Ends the simulation."""
        self._run = None


gymnasium.register(id="underact/Constraint-v0", entry_point="underact.gym:ConstraintEnv")
