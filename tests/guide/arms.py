"""Simulated arms drawn at random, and how `underact-cli identify` measures them."""

import concurrent.futures
import functools
import json
import math
import os
import pathlib
import random
import statistics
import subprocess
import tempfile

CLI = pathlib.Path(os.environ["UNDERACT_BUILD"]) / "underact-cli"
SEED = 31
COUNT = 100  # of the page
QUANTITIES = {"Mass": "mass_kg", "Friction": "friction_N", "Damping": "damping_N_s_per_m"}
SWING = "Stiffness of a free swing"


def drawn(count):
    """Arms as their files have them; the first ones are the same for every count."""
    draw, arms = random.Random(SEED), []
    for _ in range(count):
        arms.append(
            {
                "mass_kg": math.exp(draw.uniform(math.log(0.02), math.log(0.3))),
                "friction_N": math.exp(draw.uniform(math.log(0.05), math.log(0.6))),
                "damping_N_s_per_m": draw.choice((0, 1, 1, 1, 1)) * draw.uniform(0, 3),
            }
        )
    return arms


def measured(arm, seed):
    """The rows of its measurement, by their quantity."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        about = {"device": "drawn", "date": "2026-11-25"}
        known = {"underact_arm_model": 1, "name": "a", "title": "A", "provenance": about}
        json.dump({**known, **arm}, file)
        file.flush()
        done = subprocess.run(
            [CLI, "identify", "--arm-model", file.name, "--seed", str(seed), "--json"],
            capture_output=True,
            text=True,
            check=True,
            timeout=600,
        )
    return {row["quantity"]: row for row in json.loads(done.stdout)["rows"]}


@functools.lru_cache
def identified(count):
    """The measurements of so many arms."""
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        return list(pool.map(measured, drawn(count), range(1, count + 1)))


def of_axes(rows, name):
    """The same of a quantity along each axis."""
    along = [{q: row for q, row in one.items() if q.startswith(name + " along ")} for one in rows]
    return [
        abs(row["value"] - row["given"]) / row["uncertainty"]
        for one in along
        for row in one.values()
    ]


def of_mean(rows, name):
    """The same of the mean over the axes."""
    return [abs(one[name]["value"] - one[name]["given"]) / one[name]["uncertainty"] for one in rows]


def held(errors):
    """Shares within 1 and 1.96 deviations, and the worst."""
    within = [sum(error < limit for error in errors) / len(errors) for limit in (1.0, 1.96)]
    return [*within, max(errors)]


def groups(rows):
    """The errors in standard deviations: the quantities, then those along single axes."""
    found = {name.lower(): of_mean(rows, name) for name in QUANTITIES}
    found.update({f"{name.lower()} along an axis": of_axes(rows, name) for name in QUANTITIES})
    return {**found, "stiffness of a free swing": of_axes(rows, SWING)}


def coverage(count=COUNT):
    """identify.md: how often the given value lies within the stated uncertainty."""
    rows = []
    for name, errors in groups(identified(count)).items():
        once, twice, worst = held(errors)
        rows.append([name, f"{100 * once} %", f"{100 * twice} %", worst])
    return rows


def accuracy(count=COUNT):
    """identify.md: errors of the means over the axes."""
    rows, made = identified(count), []
    for name, unit, scale in (("Mass", "%", 100), ("Friction", "%", 100), ("Damping", "N s/m", 1)):
        means = [one[name] for one in rows]
        size = [row["given"] if unit == "%" else 1 for row in means]
        errors = [abs(row["value"] - row["given"]) for row in means]
        errors = sorted(scale * error / of for error, of in zip(errors, size))
        parts = statistics.median(errors), errors[math.ceil(0.9 * count) - 1], errors[-1]
        made.append([name.lower(), *(f"{part} {unit}" for part in parts)])
    return made
