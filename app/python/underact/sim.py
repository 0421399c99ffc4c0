"""The servo and a simulated arm in lockstep: as `underact-cli run --fast`, tick by tick, to the
bit.

>>> from underact import scene, sim
>>> held = scene.build("A sphere", [scene.sphere(center_mm=(0, 0, 0), radius_mm=30)])
>>> run = sim.Simulation(held, hand="sweep")
>>> run.step(500)
>>> run.state.tick, run.columns()["force_sent_N"].shape
(500, (500, 3))

The hand is a built-in one, a dict or file as of `--hand`, or a function of Python, hand(state) ->
where it wants the tip. What is recorded is a session: save() gives it, and `underact-cli rerun`
makes it again and compares every tick.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import given
from .compiled import core as _compiled
from .scene import Scene, Value, _json, read

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from . import _core
    from .session import Session
else:
    _core = _compiled()


@dataclass(frozen=True, eq=False)
class State:
    """The last tick. Lengths mm, velocities mm/s, angles rad, forces N; target_mm is NaN where
    nothing acts.

    mode: "running", "stopping", "stopped" or "fault"; fault: its name, "none" without one.
    """

    tick: int
    time_s: float
    q_rad: NDArray[np.float64]
    p_mm: NDArray[np.float64]
    v_mm_per_s: NDArray[np.float64]
    target_mm: NDArray[np.float64]
    error_mm: float
    force_N: NDArray[np.float64]
    fault: str
    mode: str

    def __eq__(self, other: object) -> bool:
        """Whether all numbers are the same; NaN is the same as NaN."""
        if not isinstance(other, State):
            return NotImplemented
        return all(_same(mine, getattr(other, name)) for name, mine in vars(self).items())

    def __hash__(self) -> int:
        return hash((self.tick, self.time_s))


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, str):
        return bool(one == other)
    return bool(np.array_equal(one, other, equal_nan=True))


#: What a function as a hand gives: a position, mm; a position and a rotation; or None, where it
#: lets go.
Hand = Callable[[State], "ArrayLike | tuple[ArrayLike, ArrayLike] | None"]


def hands() -> dict[str, str]:
    """The built-in hands, and what each does.

    >>> "sweep" in hands()
    True
    """
    return _core.hands()


def arm_models() -> dict[str, str]:
    """The models of the simulated arm, and their titles."""
    return _core.arm_models()


class Simulation:
    """A scene on the simulated arm. It starts with the servo running; use it in a `with`, or close
    it.

    scene: a Scene, or a file. hand: a name of hands(), a hand file or its content as a dict, or a
    function, which is called before every `every` ticks; without one, want() says where the hand
    wants to be. rate_hz: 100 to 10000. seed: of everything random. arm_model: of arm_models(), or a
    file. record: whether a session is recorded, to save(). keep: whether columns() has the ticks.
    """

    def __init__(
        self,
        scene: Scene | str | os.PathLike[str],
        hand: str | os.PathLike[str] | Mapping[str, Any] | Hand | None = None,
        *,
        rate_hz: int = 1000,
        seed: int = 1,
        arm_model: str = _core.DEFAULT_ARM_MODEL,
        record: bool = False,
        keep: bool = True,
        details: bool = False,
        every: int = 1,
        name: str = "",
    ):
        rate_hz = given.whole(rate_hz, "rate_hz", 100, 10_000)
        seed = given.whole(seed, "seed", 0, 2**64 - 1)
        every = given.whole(every, "every", 1, 2**62)
        name, arm_model = given.text(name, "name"), given.path(arm_model, "arm_model")
        self.scene = scene if isinstance(scene, Scene) else read(scene)
        self._hand = hand if callable(hand) else None
        self._every, self._next = every, 0
        built_in, text = self._hand_words(hand)
        self._folder = tempfile.TemporaryDirectory(prefix="underact-") if record else None
        self._file = Path(self._folder.name) / "session.h5" if self._folder else None
        words = (built_in, text, rate_hz, seed, arm_model, str(self._file or ""), name, details)
        self._core = _core.Simulation(self.scene._core, *words)
        self._core.keeps = keep

    @staticmethod
    def _hand_words(hand: Any) -> tuple[str, str]:
        """A built-in hand's name, or the text of a hand file."""
        if hand is None or callable(hand):
            return "", ""
        if isinstance(hand, Mapping):
            return "", _json(hand, "hand")
        name = given.path(hand, "hand")
        if name in hands() or not any(mark in name for mark in "./\\"):
            return name, ""
        return "", Path(name).read_text(encoding="utf-8")

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def state(self) -> State:
        """The last tick."""
        return State(*self._core.last())

    @property
    def rate_hz(self) -> int:
        """Ticks a second."""
        return self._core.rate_hz

    def step(self, ticks: int = 1) -> None:
        """Runs so many ticks."""
        ticks = given.whole(ticks, "ticks", 0, 2**62)
        if self._hand is None:
            self._core.run(ticks)
            return
        while ticks > 0:
            if self._next == 0:
                self._ask(self._hand)
                self._next = self._every
            now = min(ticks, self._next)
            self._core.run(now)
            self._next -= now
            ticks -= now

    def _ask(self, hand: Hand) -> None:
        wanted: Any = hand(self.state)
        self._core.let_go(wanted is None)
        if isinstance(wanted, tuple) and len(wanted) == 2:
            self.want(*wanted)
        elif wanted is not None:
            self.want(wanted)

    def run(self, seconds: float) -> Simulation:
        """Runs so long by the arm's clock, and gives itself."""
        self.step(round(given.number(seconds, "seconds", 0, 1e6) * self.rate_hz))
        return self

    def want(self, p_mm: ArrayLike, R_WT: ArrayLike | None = None) -> None:
        """Where the hand wants the tip, (3,), from the next tick on; it gets there within some 15
        ms.

        R_WT: (3, 3), how it wants to hold the stylus; None: the wrist stays as it is.
        """
        self._core.want(p_mm, R_WT)

    def push(self, f_N: ArrayLike, seconds: float) -> None:
        """Adds a force on the tip, (3,), before the safety gate, from the next tick on and for so
        long.
        """
        self._core.push(f_N, round(given.number(seconds, "seconds", 0, 1e6) * self.rate_hz))

    def set(self, values: Mapping[str, Value]) -> None:
        """Other values of settings by path, from the next tick on: see Scene.with_values()."""
        changed = self.scene.with_values(values)
        self._core.edit(changed._core)
        self.scene = changed

    def mark(self, label: str) -> None:
        """Sets a marker in the session."""
        self._core.mark(given.text(label, "label"))

    def columns(self) -> dict[str, NDArray[Any]]:
        """All ticks so far, as the columns of a session's table: "p_WT_mm" (ticks, 3), "error_mm"
        (ticks,) and so on.
        """
        return self._core.columns()

    def forget(self) -> None:
        """Forgets the ticks that columns() has."""
        self._core.forget()

    def save(self, path: str | os.PathLike[str], overwrite: bool = False) -> Session:
        """Ends the recording, moves it to path and opens it. `underact-cli rerun` makes it again to
        the bit.
        """
        if self._file is None:
            raise ValueError("Nothing was recorded: make the simulation with record=True.")
        path = Path(path)
        if path.exists() and not overwrite:
            raise FileExistsError(f"{path} exists; with overwrite=True it is replaced.")
        self._core.close()
        if not self._file.exists():
            raise ValueError("This recording was saved already.")
        shutil.move(self._file, path)
        from .session import Session

        return Session(path)

    def close(self) -> None:
        """Ends the recording; one that was not saved is lost."""
        self._core.close()
        if self._folder is not None:
            self._folder.cleanup()
            self._folder = None


def simulate(
    scene: Scene | str | os.PathLike[str],
    hand: str | os.PathLike[str] | Mapping[str, Any] | Hand,
    seconds: float,
    path: str | os.PathLike[str],
    *,
    overwrite: bool = False,
    **options: Any,
) -> Session:
    """Runs a scene so long and gives its session, recorded at path.

    options: those of Simulation.
    """
    with Simulation(scene, hand, record=True, keep=False, **options) as run:
        return run.run(seconds).save(path, overwrite)
