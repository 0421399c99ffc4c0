"""Pictures in 3D hold what they should, in matplotlib and in PyVista. Debian has no PyVista; the soak has that of PyPI."""

from __future__ import annotations

import inspect
import tempfile
import unittest
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import numpy as np

from underact import arm, pictures, scene, shapes, sim

OMNI = arm.load("omni-thesis")
Q = np.array([0.1, 0.5, -0.3, 0.2, 0.7, 0.4])
BALL = scene.build("A ball", [scene.sphere(center_mm=(10, 20, 30), radius_mm=25)])

NUMBERS = {
    "center_mm": (1, 2, 3), "point_mm": (1, 2, 3), "position_mm": (1, 2, 3), "direction": (1, -2, 2), "normal": (1, -2, 2),
    "axis": (1, -2, 2), "radius_mm": 25, "size_mm": (60, 40, 50), "semi_axes_mm": (60, 40, 50),
}  # fmt: skip
TURN = [[0, -1, 0], [0.6, 0, -0.8], [0.8, 0, 0.6]]


def session_of(folder: str):
    return sim.simulate(BALL, "sweep", 0.5, Path(folder) / "ball.h5")


class Outlines(unittest.TestCase):
    def test_of_every_shape_are_where_its_nearest_points_are(self):
        for name in shapes.__all__:
            make = getattr(scene, name)
            shape = make(*(NUMBERS[key] for key in inspect.signature(make).parameters if key != "others"))
            if not {"size_mm", "semi_axes_mm"}.isdisjoint(shape):
                shape["R_WB"] = TURN
            lines = shapes.outlines(shape, np.array([[10.0, -5.0, 2.0]]))
            if name != "point":  # a cross about it
                np.testing.assert_allclose(scene.nearest(shape, np.vstack(lines)), np.vstack(lines), atol=1e-9, err_msg=name)


class Matplotlib(unittest.TestCase):
    def tearDown(self):
        pyplot.close("all")

    def test_an_arm_is_drawn_from_its_base_to_its_tip(self):
        axes = OMNI.plot(Q)
        drawn = np.array(axes.lines[0].get_data_3d()).T
        np.testing.assert_allclose(drawn, OMNI.skeleton(Q), atol=1e-12)
        np.testing.assert_allclose(drawn[-1], OMNI.fk(Q)[:3, 3], atol=1e-9)
        self.assertEqual(len(OMNI.plot([Q, 2 * Q]).lines), 2 * len(axes.lines))

    def test_a_line_of_the_arm_looks_as_asked_for(self):
        self.assertEqual(OMNI.plot(Q, color="red").lines[0].get_color(), "red")

    def test_a_millimetre_is_as_long_along_each_axis(self):
        axes = BALL.plot(OMNI.plot(Q))
        spans = [np.ptp(limits) for limits in (axes.get_xlim(), axes.get_ylim(), axes.get_zlim())]
        np.testing.assert_allclose(spans, spans[0])

    def test_a_session_is_its_path_and_its_shapes(self):
        with tempfile.TemporaryDirectory() as folder, session_of(folder) as session:
            axes = pictures.plot_session(session)
            path = np.array(axes.lines[-1].get_data_3d()).T
            np.testing.assert_array_equal(path, session.ticks["p_WT_mm"])
            circle = np.array(axes.lines[0].get_data_3d()).T
        np.testing.assert_allclose(np.linalg.norm(circle - (10, 20, 30), axis=1), 25)

    def test_what_cannot_be_drawn_into_is_refused(self):
        for wrong in ("vista", 3, pyplot.figure()):
            with self.assertRaisesRegex(TypeError, "matplotlib"):
                OMNI.plot(Q, wrong)


class PyVista(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        try:
            import pyvista
        except ImportError as error:
            raise unittest.SkipTest("pyvista is not installed (Debian has none; packaging/soak takes that of PyPI), so nothing was drawn with it") from error
        pyvista.OFF_SCREEN = True

    def test_an_arm_in_a_scene_is_drawn(self):
        import pyvista

        plotter = BALL.plot(OMNI.plot(Q, "pyvista"))
        self.assertIsInstance(plotter, pyvista.Plotter)
        bounds = np.reshape(plotter.bounds, (3, 2))
        for point in (*OMNI.skeleton(Q), (35, 20, 30), (10, 20, 55)):
            self.assertTrue((bounds[:, 0] - 1e-3 <= point).all() and (point <= bounds[:, 1] + 1e-3).all(), point)
        picture = plotter.screenshot(return_img=True)
        self.assertGreater(len(np.unique(picture.reshape(-1, 3), axis=0)), 10)
        plotter.close()

    def test_a_mesh_is_a_surface(self):
        held = scene.read(Path(__file__).resolve().parents[2] / "scenes/27_bracket.json")
        plotter = held.plot("pyvista")
        at, faces = held.mesh(0)
        meshes = [actor.mapper.dataset for actor in plotter.actors.values() if getattr(actor, "mapper", None) is not None]
        self.assertIn((len(at), len(faces)), [(mesh.n_points, mesh.n_cells) for mesh in meshes])
        plotter.close()

    def test_a_session_is_drawn(self):
        with tempfile.TemporaryDirectory() as folder, session_of(folder) as session:
            plotter = pictures.plot_session(session, "pyvista")
        self.assertGreater(len(plotter.actors), 3)
        plotter.close()


if __name__ == "__main__":
    unittest.main()
