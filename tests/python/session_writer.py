"""Writes session files by the letter of resources/guide/session_file.md: the tests' double of
the program's own writer.
"""

from __future__ import annotations

import json
import zlib
from pathlib import Path

import h5py
import numpy as np
from underact import layout

NAMES = ("ticks", "changes", "markers", "faults", "end", "text")
TABLES = {**{name: layout.TABLES[name] for name in NAMES}, "start": {"bytes": 1}}
TICKS = TABLES["ticks"]
SCENE = {
    "underact_scene": 1,
    "title": "Sphere",
    "control": {"law": "P", "kp_N_per_mm": 0.5},
    "constraints": [{"name": "ball", "type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 50}],
}


class Writer:
    """One session file; ticks() appends rows as whole blocks, end() closes it in order."""

    def __init__(self, path: Path, scene: dict = SCENE, block_rows: int = 100):
        self.file = h5py.File(path, "w", libver=("v110", "v110"))
        for name, columns in TABLES.items():
            rows = {"ticks": block_rows, "text": 64, "start": 4096}.get(name, 1)
            chunk = {"ticks": block_rows, "text": 1024, "start": 4096, "end": 1}.get(name, 64)
            group = self.file.create_group(name)
            group.attrs["columns"] = np.bytes_(",".join(columns))
            group.attrs["block_rows"] = np.int64(rows)
            for column, width in columns.items():
                shape = (0,) if width == 1 else (0, width)
                dataset = group.create_dataset(
                    column,
                    shape,
                    layout.TYPES.get(column, "<f8"),
                    maxshape=(None, *shape[1:]),
                    chunks=(chunk, *shape[1:]),
                )
                dataset.attrs["unit"] = np.bytes_(
                    column.rsplit("_", 1)[-1] if "_" in column else "1"
                )
                dataset.attrs["meaning"] = np.bytes_(f"the {column} of a row")
            group.create_dataset("crc32", (0,), "<u4", maxshape=(None,), chunks=(64,))
        attributes = {
            "underact_session": np.int64(1),
            "program_version": b"0.1.0",
            "name": b"",
            "notes": b"",
            "tags": b"",
            "subject": b"",
            "consent": b"form 2.1",
            "scene_title": scene["title"].encode(),
            "arm": b"omni-thesis",
            "arm_file": b"{}",
            "device": b"simulated arm",
            "scheduling": b"as fast as possible",
            "started_unix_ns": np.int64(10**18),
            "rate_hz": np.int64(1000),
            "frozen_s": 0.0,
            "max_late": np.int64(20),
            "start_layout": np.int64(1),
        }
        for name, value in attributes.items():
            self.file.attrs[name] = np.bytes_(value) if isinstance(value, bytes) else value
        self.texts = 0
        self.append("start", {"bytes": np.zeros(32, "u1")})
        self.change(1, 1, 0, scene)

    def append(self, table: str, columns: dict[str, np.ndarray]) -> None:
        group = self.file[table]
        order = group.attrs["columns"].decode().split(",")
        size = int(group.attrs["block_rows"])
        stored = {c: np.ascontiguousarray(columns[c], dtype=group[c].dtype) for c in order}
        rows = len(stored[order[0]])
        for begin in range(0, rows, size):
            crc = 0
            for column in order:
                block = stored[column][begin : begin + size]
                crc = zlib.crc32(block.tobytes(), crc)
                dataset = group[column]
                at = dataset.shape[0]
                dataset.resize(at + len(block), axis=0)
                dataset[at:] = block
            crc32 = group["crc32"]
            crc32.resize(crc32.shape[0] + 1, axis=0)
            crc32[-1] = crc

    def _text(self, words: str) -> tuple[int, int]:
        """Appends words, filled up with zeros to whole blocks."""
        stored = words.encode()
        size = int(self.file["text"].attrs["block_rows"])
        padded = stored + bytes(-len(stored) % size)
        self.append("text", {"bytes": np.frombuffer(padded, "u1")})
        at = self.texts
        self.texts += len(padded)
        return at, len(stored)

    def change(self, tick: int, revision: int, carry: int, scene: dict) -> None:
        at, size = self._text(json.dumps(scene))
        row = {
            "tick": [tick],
            "revision": [revision],
            "carry": [carry],
            "text_at": [at],
            "text_bytes": [size],
        }
        self.append("changes", row)

    def mark(self, tick: int, label: str) -> None:
        at, size = self._text(label)
        self.append("markers", {"tick": [tick], "text_at": [at], "text_bytes": [size]})

    def fault(self, tick: int, kind: int, seen: float, allowed: float) -> None:
        self.append(
            "faults",
            {
                "tick": [tick],
                "kind": [kind],
                "seen": [seen],
                "allowed": [allowed],
                "from_servo": [1],
            },
        )

    def ticks(self, columns: dict[str, np.ndarray]) -> None:
        """Columns that are not given are 0."""
        rows = len(columns["tick"])
        empty = {name: np.zeros((rows, width)[: 1 + (width > 1)]) for name, width in TICKS.items()}
        self.append("ticks", {**empty, **columns})

    def start_swmr(self) -> None:
        self.file.swmr_mode = True

    def flush(self) -> None:
        for name in TABLES:
            for dataset in self.file[name].values():
                dataset.flush()

    def end(self, tick: int, reason: int = 0) -> None:
        self.append(
            "end", {"tick": [tick], "dropped": [0], "unix_ns": [10**18 + 10**9], "reason": [reason]}
        )
        self.file.close()


def sphere_ticks(
    rows: int, first: int = 1, seed: int = 1, kp_N_per_mm: float = 0.5
) -> dict[str, np.ndarray]:
    """Ticks of a stylus that circles about a sphere of 50 mm, at 1 kHz; all columns, by the
    law P with a clamp.
    """
    tick = np.arange(first, first + rows)
    t_s = tick * 1e-3
    random = np.random.default_rng(seed)
    radius_mm = 50 + 2.5 * np.sin(2 * np.pi * 1.3 * t_s)
    direction = np.stack([np.cos(2 * t_s), 0.4 * np.sin(3 * t_s), np.sin(2 * t_s)], axis=1)
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    p_WT, p_WP = radius_mm[:, None] * direction, 50 * direction
    asked = kp_N_per_mm * (p_WP - p_WT)
    size = np.linalg.norm(asked, axis=1)
    sent = asked * np.minimum(1, 0.88 / np.maximum(size, 1e-9))[:, None]
    alpha, beta = np.sin(t_s), np.cos(t_s)
    return {
        "tick": tick,
        "time_ns": tick * 1_000_000,
        "q_rad": 0.1 * np.sin(np.outer(t_s, np.arange(1, 7))),
        "buttons": (t_s % 1 > 0.5).astype("u4"),
        "p_WT_mm": p_WT,
        "quat_WT": np.tile([1.0, 0, 0, 0], (rows, 1)),
        "v_WT_mm_per_s": np.gradient(p_WT, 1e-3, axis=0) if rows > 1 else np.zeros((rows, 3)),
        "p_WP_mm": p_WP,
        "error_mm": np.abs(radius_mm - 50),
        "force_asked_N": asked,
        "force_sent_N": sent,
        "gate_level": np.minimum(1, t_s / 0.3),
        "cut_N": size - np.linalg.norm(sent, axis=1),
        "limits": (size > 0.88).astype("u4"),
        "heat": 0.01 * np.ones((rows, 3)),
        "fault": np.zeros(rows, "u1"),
        "alpha_beta_theta_rad": np.stack([alpha, beta, 0.5 * (alpha + beta)], axis=1),
        "energy_mJ": 0.25 * (radius_mm - 50) ** 2 - 0.2,
        "passive_N": np.zeros(rows),
        "lateness_us": random.gamma(2.0, 5.0, rows),
        "tick_us": 0.3 + 0.05 * random.random(rows),
        "revision": np.ones(rows, "i8"),
        "input": np.full(rows, 3, "u1"),
    }


def write_session(path: Path, rows: int = 2050) -> Path:
    """A whole session: ticks, an edit, a marker, a fault, an end."""
    writer = Writer(path)
    writer.ticks(sphere_ticks(rows))
    writer.change(1000, 2, 1, {**SCENE, "control": {"law": "P", "kp_N_per_mm": 0.4}})
    writer.mark(500, "pressed harder, à peine")
    writer.fault(1500, 4, 2.3, 1.0)
    writer.end(rows)
    return path
