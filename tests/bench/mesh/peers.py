"""Usage: peers.py CASE ANSWERS. Nearest points by FCPW and libigl, through Python, one query a call.

What a call costs by itself is in the note, measured by a query that has nothing to look for, and is
not taken off. Prints the lines that tests/bench/mesh/case.h describes; a package that is not
installed has none.
"""

import struct
import sys
import time
from pathlib import Path
from typing import Callable

import numpy as np

TURNS = 5
Ask = Callable[[np.ndarray], float]


def read(path: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    data = Path(path).read_bytes()
    corners, faces, points = struct.unpack_from("3I", data)
    at = 12
    vertices = np.frombuffer(data, np.float32, 3 * corners, at).reshape(-1, 3)
    at += vertices.nbytes
    triangles = np.frombuffer(data, np.int32, 3 * faces, at).reshape(-1, 3)
    at += triangles.nbytes
    return vertices, triangles, np.frombuffer(data, np.float64, 6 * points, at).reshape(2, -1, 3)


def resident_mb() -> float:
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096 / 1e6


def timed(ask: Ask, points: np.ndarray, turns: int = TURNS) -> tuple[np.ndarray, np.ndarray]:
    """Answers, and of each query's times the middle one, us; the clock's own cost taken off."""
    clock = time.perf_counter_ns
    nothing = []
    for _ in range(10000):
        begin = clock()
        nothing.append(clock() - begin)
    cost = float(np.median(nothing))
    answers = np.empty(len(points))
    times = np.empty((turns + 1, len(points)))
    for turn in range(turns + 1):
        for i, point in enumerate(points):
            begin = clock()
            answers[i] = ask(point)
            times[turn, i] = clock() - begin - cost
    return answers, np.median(times[1:], axis=0) / 1e3


def tell(
    name: str,
    build_ms: float,
    grown_mb: float,
    ask: Ask,
    nothing: Ask,
    lists: list[np.ndarray],
    note: str,
    path: str,
) -> None:
    answers, shares = [], []
    for points in lists:
        squared, times = timed(ask, points)
        answers.append(squared)
        shares += [np.percentile(times, 50), np.percentile(times, 99)]
    _, empty = timed(nothing, lists[0][:1000], 1)
    np.concatenate(answers).tofile(path)
    fields = [name, f"{build_ms:.6g}", f"{grown_mb:.6g}", "-1", *(f"{share:.6g}" for share in shares)]
    print("|".join([*fields, f"{note}, of which the call {np.median(empty):.1f} us"]), flush=True)


def fcpw_line(vertices: np.ndarray, triangles: np.ndarray, lists: np.ndarray, path: str) -> bool:
    try:
        import fcpw
    except ImportError:
        return False
    before, begin = resident_mb(), time.perf_counter()
    scene = fcpw.scene_3D()
    scene.set_object_count(1)
    scene.set_object_vertices(np.asfortranarray(vertices), 0)
    scene.set_object_triangles(np.asfortranarray(triangles), 0)
    scene.build(fcpw.aggregate_type.bvh_surface_area, True)
    built, grown = time.perf_counter() - begin, resident_mb() - before
    found = fcpw.interaction_3D()

    def ask(point: np.ndarray) -> float:
        scene.find_closest_point(point, found)
        return found.d * found.d

    def nothing(point: np.ndarray) -> float:  # no ball to look in
        scene.find_closest_point(point, found, 0.0)
        return found.d * found.d

    points = [np.ascontiguousarray(one, np.float32) for one in lists]
    tell("FCPW, Python", 1e3 * built, grown, ask, nothing, points, "floats", path)
    return True


def libigl_line(vertices: np.ndarray, triangles: np.ndarray, lists: np.ndarray, path: str) -> bool:
    try:
        import igl
    except ImportError:
        return False
    before, begin = resident_mb(), time.perf_counter()
    places, numbers = np.asfortranarray(vertices, np.float64), np.asfortranarray(triangles, np.int64)
    tree = igl.AABB()
    tree.init(places, numbers)
    built, grown = time.perf_counter() - begin, resident_mb() - before
    none = np.empty((0, 3))

    def ask(point: np.ndarray) -> float:
        return tree.squared_distance(places, numbers, point)[0].item()

    def nothing(_: np.ndarray) -> float:
        return float(len(tree.squared_distance(places, numbers, none)[0]))

    # An array of one point each, made before the clock runs.
    points = [np.ascontiguousarray(one).reshape(-1, 1, 3) for one in lists]
    tell("libigl, Python", 1e3 * built, grown, ask, nothing, points, "doubles", path)
    return True


def main() -> None:
    vertices, triangles, lists = read(sys.argv[1])
    told = 0
    for line in (fcpw_line, libigl_line):
        told += line(vertices, triangles, lists, f"{sys.argv[2]}.{told}")


if __name__ == "__main__":
    main()
