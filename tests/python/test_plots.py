"""Each plot names its axes with units, shows what is there, and is the same bytes each time."""

import hashlib
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import matplotlib.image
import numpy as np
from session_writer import SCENE, Writer, sphere_ticks, write_session
from support import InFolder, command
from underact import Session, SessionError, plots, style
from underact.plots.over_time import unbroken
from underact.plots.statistics import density
from underact.plots.view import view_of
from underact.shapes import outlines
from underact.thin import evenly, thin

LABELS = {  # of the panels from the top, x after the last
    "error": ["distance to target [mm]", "time [s]"],
    "force": ["force [N]", "components [N]", "time [s]"],
    "displacement-force": [
        "force sent [N]",
        "displacement in x [mm]",
        "displacement in y [mm]",
        "displacement in z [mm]",
    ],
    "path": ["x [mm]", "y [mm]", "z [mm]", "force sent [N]"],
    "angles": ["angle about the axis [deg]", "time [s]"],
    "joints": ["joint angle [deg]", "time [s]"],
    "energy": ["energy put in [mJ]", "time [s]"],
    "spectrum": ["error [mm/√Hz]", "force [N/√Hz]", "frequency [Hz]"],
    "lateness": ["latency, time of a tick [µs]", "ticks"],
}


def labels(figure) -> set[str]:
    found = set()
    for axes in figure.axes:
        found |= {
            axes.get_xlabel(),
            axes.get_ylabel(),
            axes.get_zlabel() if hasattr(axes, "get_zlabel") else "",
        }
    return found - {""}


def view(**more):
    with tempfile.TemporaryDirectory() as folder:
        with Session(write_session(Path(folder) / "a.h5", 2050)) as session:
            return view_of(session, **more)


class EachPlot(InFolder):
    def test_names_its_axes_with_units(self):
        self.assertEqual(set(LABELS), set(plots.KINDS))
        for kind, words in LABELS.items():
            for width_in in style.WIDTHS_IN:
                figure = plots.draw(kind, view(), width_in)
                self.assertEqual(labels(figure), set(words), kind)
                self.assertEqual(figure.get_figwidth(), width_in)

    def test_says_where_its_data_come_from(self):
        for kind in plots.KINDS:
            words = plots.draw(kind, view())._supxlabel.get_text()
            for part in ("Sphere", "omni-thesis", "Underact 0.1.0"):
                self.assertIn(part, words, kind)

    def test_shows_something_on_white(self):
        for kind in plots.KINDS:
            path = self.folder / f"{kind}.png"
            style.save(plots.draw(kind, view()), path)
            image = matplotlib.image.imread(path)[:, :, :3]
            self.assertEqual(image.shape[1], 2100)
            np.testing.assert_array_equal(image[:3, :3], 1.0)
            inked = float(np.mean(image.min(axis=2) < 0.9))
            self.assertGreater(inked, 0.005, kind)  # an empty frame with its labels has less
            self.assertLess(inked, 0.5, kind)

    @mock.patch.object(style, "DPI", 60)  # coarse is enough to see a change
    def test_changes_with_the_data(self):
        still = view()
        for name in (
            "error_mm",
            "force_sent_N",
            "p_WT_mm",
            "q_rad",
            "energy_mJ",
            "alpha_beta_theta_rad",
            "lateness_us",
        ):
            still.columns[name] = 0.5 * still.columns[name]
        for kind in plots.KINDS:
            sums = []
            for one in (view(), still):
                style.save(plots.draw(kind, one), self.folder / "a.png")
                sums.append(hashlib.sha256((self.folder / "a.png").read_bytes()).digest())
            self.assertNotEqual(*sums, kind)

    def test_is_the_same_bytes_each_time(self):
        for ending in style.FORMATS:
            written = []
            for name in ("a", "b"):
                path = self.folder / f"{name}.{ending}"
                style.save(plots.draw("force", view()), path)
                written.append(path.read_bytes())
            self.assertEqual(*written, ending)
            self.assertNotIn(b"CreationDate", written[0])

    @mock.patch.object(style, "DPI", 60)
    def test_of_one_tick_or_of_nothing_acting_can_be_drawn(self):
        writer = Writer(self.folder / "a.h5")
        ticks = sphere_ticks(1)
        for name in ("p_WP_mm", "alpha_beta_theta_rad"):
            ticks[name] = np.full((1, 3), np.nan)
        writer.ticks(ticks)
        writer.end(1)
        with Session(self.folder / "a.h5") as session:
            one = view_of(session)
        for kind in plots.KINDS:
            style.save(plots.draw(kind, one), self.folder / "a.svg")

    def test_marks_faults_and_marks(self):
        words = [text.get_text() for text in plots.draw("error", view()).axes[0].texts]
        self.assertEqual(words, ["too_fast", "pressed harder, à peine"])

    def test_refuses_what_it_cannot_draw(self):
        with self.assertRaisesRegex(ValueError, "there are error, force"):
            plots.draw("colour", view())
        with self.assertRaisesRegex(ValueError, "2 to 40 inches"):
            plots.draw("error", view(), float("nan"))
        with self.assertRaisesRegex(ValueError, "ends in .png, .svg or .pdf"):
            style.save(plots.draw("error", view()), self.folder / "a.bmp")


class AView(InFolder):
    def test_is_the_stretch_asked_for(self):
        part = view(from_s=0.5, to_s=1.0)
        self.assertEqual(len(part.time_s), 501)
        self.assertEqual(part["tick"][0], 501)
        self.assertEqual(part.faults, [])
        self.assertEqual(view(from_s=1.4).faults, [(1.499, "too_fast")])

    def test_of_nothing_is_refused(self):
        with self.assertRaisesRegex(SessionError, "no tick from 7 s"):
            view(from_s=7.0)


class TheCommand(InFolder):
    def test_draws_one_or_all(self):
        path = write_session(self.folder / "a.h5", 400)
        self.assertEqual(
            command(
                "plot", path, "--kind", "energy", "--out", self.folder / "e.pdf", "--width", 3.5
            )[0],
            0,
        )
        self.assertTrue((self.folder / "e.pdf").read_bytes().startswith(b"%PDF"))
        self.assertEqual(
            command("plot", path, "--kind", "all", "--out", self.folder / "p.svg")[0], 0
        )
        self.assertEqual(
            {f.stem for f in self.folder.glob("*.svg")}, {f"p_{kind}" for kind in plots.KINDS}
        )

    def test_tells_what_is_wrong_by_its_exit_status(self):
        path = write_session(self.folder / "a.h5", 400)
        out = self.folder / "p.png"
        cases = (
            (("plot", path, "--kind", "error", "--out", "p.bmp"), 2, "ends in .png"),
            (
                ("plot", path, "--kind", "error", "--out", out, "--width", "0.1"),
                2,
                "2 to 40 inches",
            ),
            (
                ("plot", path, "--kind", "error", "--out", out, "--from", "9"),
                1,
                "has no tick from 9 s",
            ),
            (
                ("plot", self.folder / "none.h5", "--kind", "error", "--out", out),
                4,
                "cannot be read",
            ),
            (
                ("plot", path, "--kind", "error", "--out", self.folder / "no" / "p.png"),
                4,
                "No such file",
            ),
            (("plot", path, "--kind", "colour", "--out", out), 2, "invalid choice"),
            (("plot", __file__, "--kind", "error", "--out", out), 1, "not an HDF5 file"),
        )
        for words, wanted, sentence in cases:
            status, printed, error = command(*words)
            self.assertEqual((status, printed), (wanted, ""), words)
            self.assertIn(sentence, error)
        self.assertFalse(out.exists())


class Thinning(unittest.TestCase):
    def test_keeps_each_peak_and_each_gap(self):
        x = np.arange(1_000_000) * 1e-3
        y = np.sin(x)
        y[123_456], y[654_321] = 7.0, -7.0
        y[777_100:777_105] = np.nan
        few_x, few_y = thin(x, y, 1000)
        self.assertLessEqual(len(few_x), 5000)
        self.assertEqual((np.nanmax(few_y), np.nanmin(few_y)), (7.0, -7.0))
        self.assertTrue(np.isnan(few_y).any())
        self.assertTrue((np.diff(few_x) > 0).all())
        self.assertEqual((few_x[0], few_x[-1]), (x[0], x[-1]))
        np.testing.assert_array_equal(few_y, y[np.searchsorted(x, few_x)])

    def test_covers_in_each_pixel_what_all_points_cover(self):
        random = np.random.default_rng(20070601)
        x, y = np.sort(random.random(50_000)), random.standard_normal(50_000)
        few_x, few_y = thin(x, y, 100)
        pixel = np.minimum(((x - x[0]) * (100 / (x[-1] - x[0]))).astype(int), 99)
        few_pixel = np.minimum(((few_x - x[0]) * (100 / (x[-1] - x[0]))).astype(int), 99)
        for at in range(100):
            self.assertEqual(y[pixel == at].max(), few_y[few_pixel == at].max())
            self.assertEqual(y[pixel == at].min(), few_y[few_pixel == at].min())

    def test_leaves_short_data_and_constant_time_alone(self):
        x = np.arange(10.0)
        self.assertIs(thin(x, x, 100)[0], x)
        self.assertLessEqual(len(thin(np.zeros(1000), np.arange(1000.0), 10)[0]), 40)
        self.assertEqual(evenly(10, 4).tolist(), [0, 3, 6, 9])


class TheSpectrum(unittest.TestCase):
    def test_of_a_sine_has_its_power_at_its_frequency(self):
        time_s = np.arange(8192) / 1000
        frequency, power = density(3.0 * np.sin(2 * np.pi * 62.5 * time_s), 1000.0)
        self.assertAlmostEqual(frequency[np.argmax(power)], 62.5)
        self.assertAlmostEqual(
            power.sum() * (frequency[1] - frequency[0]), 4.5, 6
        )  # amplitude^2 / 2

    def test_of_noise_holds_its_variance(self):
        noise = np.random.default_rng(1).standard_normal(100_000)
        frequency, power = density(noise, 500.0)
        self.assertAlmostEqual(power.sum() * (frequency[1] - frequency[0]), 1.0, 1)
        self.assertEqual(frequency[-1], 250.0)

    def test_of_too_little_is_empty(self):
        self.assertEqual(len(density(np.ones(7), 1000.0)[0]), 0)


class Shapes(unittest.TestCase):
    SHAPES = (
        (
            {"type": "sphere", "center_mm": [1, 2, 3], "radius_mm": 5},
            lambda p: np.linalg.norm(p - [1, 2, 3], axis=1) - 5,
        ),
        (
            {"type": "plane", "point_mm": [0, 0, 4], "normal": [1, 1, 1]},
            lambda p: (p - [0, 0, 4]) @ np.ones(3),
        ),
        (
            {"type": "cylinder", "point_mm": [0, 9, 0], "axis": [0, 0, 2], "radius_mm": 3},
            lambda p: np.hypot(p[:, 0], p[:, 1] - 9) - 3,
        ),
        (
            {"type": "circle", "center_mm": [0, 0, 7], "normal": [0, 0, -1], "radius_mm": 3},
            lambda p: np.abs(np.hypot(p[:, 0], p[:, 1]) - 3) + np.abs(p[:, 2] - 7),
        ),
        (
            {"type": "line", "point_mm": [0, 30, 0], "direction": [-1, -2, 1]},
            lambda p: np.linalg.norm(np.cross(p - [0, 30, 0], [-1, -2, 1]), axis=1),
        ),
        (
            {"type": "box", "center_mm": [0, 0, 0], "size_mm": [2, 4, 6]},
            lambda p: np.max(np.abs(p) / [1, 2, 3], axis=1) - 1,
        ),
    )

    def test_are_drawn_where_they_are(self):
        for constraint, off in self.SHAPES:
            for line in outlines(constraint, np.array([[10.0, -5.0, 2.0]])):
                np.testing.assert_allclose(off(line), 0, atol=1e-9, err_msg=constraint["type"])

    def test_of_no_shape_are_no_lines(self):
        self.assertEqual(outlines({"type": "virtual_manipulator"}, np.zeros((1, 3))), [])
        self.assertEqual(
            len(outlines({"type": "point", "position_mm": [1, 2, 3]}, np.zeros((1, 3)))), 3
        )
        self.assertEqual(SCENE["constraints"][0]["type"], "sphere")

    def test_angles_break_where_they_wrap(self):
        angle = unbroken(np.array([3.0, 3.1, -3.1, -3.0]))
        self.assertEqual(np.isnan(angle).tolist(), [False, False, True, False])


if __name__ == "__main__":
    unittest.main()
