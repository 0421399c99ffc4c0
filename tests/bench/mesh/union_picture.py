"""The picture of the guide's page of meshes: a body of convex parts in section, as it is given and as it is felt.

python3 -B union_picture.py FOLDER OUT.png, after underact-mesh-union-bench --write FOLDER.

Left, the walls that the faces make, and where a tip inside would not be pushed out if its nearest
face alone said on which side it is. Right, the same for the surface of the union.
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

PLANE_Y = 1.3  # mm; through no vertex
STEP = 0.4  # mm, between tips


def triangles(path: Path) -> np.ndarray:
    """Corners, (n, 3, 3), of an OFF file."""
    numbers = path.read_text(encoding="utf-8").split()[1:]
    corners, faces = int(numbers[0]), int(numbers[1])
    points = np.array(numbers[3 : 3 + 3 * corners], float).reshape(-1, 3)
    rows = np.array(numbers[3 + 3 * corners :], int).reshape(faces, 4)
    return points[rows[:, 1:]]


def section(faces: np.ndarray) -> list[np.ndarray]:
    """Where faces meet the plane: segments in x and z."""
    found = []
    for face in faces:
        ends = []
        for a, b in zip(face, np.roll(face, -1, axis=0)):
            if (a[1] - PLANE_Y) * (b[1] - PLANE_Y) < 0.0:
                ends.append(a + (PLANE_Y - a[1]) / (b[1] - a[1]) * (b - a))
        if len(ends) == 2:
            found.append(np.array(ends)[:, [0, 2]])
    return found


def winding(faces: np.ndarray, tips: np.ndarray) -> np.ndarray:
    """Solid angles by Van Oosterom and Strackee 1983."""
    a, b, c = (faces[None, :, k, :] - tips[:, None, :] for k in range(3))
    x, y, z = (np.linalg.norm(one, axis=2) for one in (a, b, c))

    def dot(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        return np.einsum("ijk,ijk->ij", u, v)

    below = x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y
    return np.arctan2(dot(a, np.cross(b, c)), below).sum(axis=1) / (2.0 * np.pi)


def is_behind_nearest(faces: np.ndarray, tips: np.ndarray) -> np.ndarray:
    """Whether the tips are behind the face that is nearest to each; at an edge, the one seen more from above."""
    best, best_height = np.full(len(tips), np.inf), np.zeros(len(tips))
    for p, q, r in faces:
        u, v, w = q - p, r - p, tips - p
        uu, uv, vv, wu, wv = u @ u, u @ v, v @ v, w @ u, w @ v
        whole = uu * vv - uv * uv
        if whole <= 0.0:
            continue
        s, t = (vv * wu - uv * wv) / whole, (uu * wv - uv * wu) / whole
        near = p + s[:, None] * u + t[:, None] * v
        off = (s < 0.0) | (t < 0.0) | (s + t > 1.0)
        distance = np.where(off, np.inf, np.linalg.norm(tips - near, axis=1))
        for a, b in ((p, q), (q, r), (r, p)):
            share = np.clip((tips - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
            there = np.linalg.norm(tips - (a + share[:, None] * (b - a)), axis=1)
            distance = np.minimum(distance, there)
        height = w @ np.cross(u, v) / np.linalg.norm(np.cross(u, v))
        is_tie = np.abs(distance - best) <= 1e-9
        nearer = (distance < best - 1e-9) | (is_tie & (np.abs(height) > np.abs(best_height)))
        best = np.where(nearer, distance, best)
        best_height = np.where(nearer, height, best_height)
    return best_height < 0.0


def main() -> None:
    folder, out = Path(sys.argv[1]), Path(sys.argv[2])
    given, felt = triangles(folder / "given.off"), triangles(folder / "felt.off")
    x, z = np.meshgrid(np.arange(-30.0, 32.0, STEP), np.arange(-29.0, 36.0, STEP))
    tips = np.column_stack([x.ravel(), np.full(x.size, PLANE_Y), z.ravel()])
    inside = winding(given, tips) > 0.5
    figure, axes = plt.subplots(1, 2, figsize=(9.4, 4.9), sharey=True, layout="constrained")
    for axis, faces, title in ((axes[0], given, "The faces of the file"), (axes[1], felt, "What is felt")):
        free = inside & ~is_behind_nearest(faces, tips)
        image = np.where(free, 2.0, np.where(inside, 1.0, np.nan)).reshape(x.shape)
        axis.pcolormesh(x, z, image, cmap=matplotlib.colors.ListedColormap(["#d9e6f2", "#e07a5f"]), vmin=1, vmax=2)
        axis.add_collection(LineCollection(section(faces), colors="#1b3a57", linewidths=1.6))
        share = 100.0 * free.sum() / inside.sum()
        axis.set_title(f"{title}: no force in {share:.0f} % of the inside", fontsize=11)
        axis.set_aspect("equal")
        axis.set_xlabel("x, mm")
        print(f"{title}: {len(faces)} faces, {free.sum()} of {inside.sum()} tips inside without force")
    axes[0].set_ylabel("z, mm")
    figure.savefig(out, dpi=120)


if __name__ == "__main__":
    main()
