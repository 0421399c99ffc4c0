"""What the tests of the compiled part share: the command line, asked the same; random numbers of a seed."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
os.environ.pop("LD_PRELOAD", None)  # of ASan, which is loaded: the programs asked have little memory, and no room for it
CLI = Path(os.environ.get("UNDERACT_CLI", ROOT / "build/release/underact-cli"))
SOAK = os.environ.get("UNDERACT_SOAK") == "1"
ARMS = sorted(path.stem for path in (ROOT / "resources/arms").glob("*.json"))


def asked(words: list[object], lines: list[dict]) -> list[dict]:
    """The answers of `underact-cli WORDS` to lines."""
    text = "".join(json.dumps(line) + "\n" for line in lines)
    done = subprocess.run([CLI, *map(str, words)], input=text, capture_output=True, text=True, check=False)
    # "-0" is the number -0.0, and no whole number for Python to make 0 of.
    answers = [json.loads(line, parse_int=float) for line in done.stdout.splitlines()]
    if len(answers) != len(lines):
        raise AssertionError(f"{words}: {len(answers)} answers to {len(lines)} lines. {done.stderr}")
    return answers


def same(one: object, other: object) -> bool:
    """Whether both are the same numbers to the last bit, NaN and null alike; 0 and -0 differ."""
    a, b = (np.array(numbers, dtype=float) for numbers in (one, other))
    return a.shape == b.shape and bool(np.all((a.view(np.int64) == b.view(np.int64)) | (np.isnan(a) & np.isnan(b))))


def golden(name: str) -> dict:
    """A file of tests/golden."""
    return json.loads((ROOT / "tests/golden" / f"{name}.json").read_text())


def random_joints(arm: object, count: int, seed: int) -> np.ndarray:
    """(count, n): within the limits, or within a turn either way (a metre, where a joint slides)."""
    low, high = arm.limits.T
    span = np.array([np.pi if joint.turns else 1000.0 for joint in arm.joints])
    low, high = np.where(np.isfinite(low), low, -span), np.where(np.isfinite(high), high, span)
    return np.random.default_rng(seed).uniform(low, high, (count, arm.n))
