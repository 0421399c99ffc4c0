"""What is written comes back; what is no session is told apart, in a sentence."""

import os
import signal
import unittest

import h5py
import numpy as np
from session_writer import SCENE, TICKS, Writer, sphere_ticks, write_session
from support import ROOT, InFolder, command
from underact import Change, End, Fault, Marker, Session, SessionError, Unreadable, layout
from underact.info import info_of


class ASession(InFolder):
    def test_gives_every_column_as_written(self):
        path = write_session(self.folder / "a.h5", 2050)
        wanted = sphere_ticks(2050)
        with Session(path) as session:
            self.assertEqual(set(session.ticks), set(TICKS))
            for name, values in wanted.items():
                np.testing.assert_array_equal(session.ticks[name], values, name)
            np.testing.assert_array_equal(session.time_s, wanted["time_ns"] * 1e-9)
            self.assertEqual(session.ticks.rows, 2050)
            self.assertAlmostEqual(session.duration_s, 2.049, 12)

    def test_gives_scene_changes_markers_faults_and_end(self):
        with Session(write_session(self.folder / "a.h5")) as session:
            self.assertEqual(session.scene, SCENE)
            edited = {**SCENE, "control": {"law": "P", "kp_N_per_mm": 0.4}}
            self.assertEqual(
                session.changes, [Change(1, 1, "loaded", SCENE), Change(1000, 2, "gains", edited)]
            )
            self.assertEqual(session.markers, [Marker(500, "pressed harder, à peine")])
            self.assertEqual(session.faults, [Fault(1500, "too_fast", 2.3, 1.0, True)])
            self.assertEqual(session.end, End(2050, 0, 10**18 + 10**9, "stopped"))
            self.assertTrue(session.complete)
            self.assertEqual(session.attributes["scene_title"], "Sphere")
            self.assertEqual(session.ticks.meanings["q_rad"], "the q_rad of a row")
            self.assertEqual(session.ticks.units["q_rad"], "rad")

    def test_prints_its_words_as_lines_that_do_not_operate_a_terminal(self):
        hostile = "\x1b]0;x\x07\x1b[2J\x9b\u202e\r\nFORGED"
        path = write_session(self.folder / "a.h5")
        with h5py.File(path, "r+") as file:
            for name in ("name", "notes", "subject", "scene_title"):
                file.attrs[name] = np.bytes_(hostile.encode())
        none = self.folder / f"none{hostile}.h5"
        for words in (["info", path], ["info", path, "--json"], ["info", none]):
            _, out, error = command(*words)
            shown = out + error
            self.assertIn("\\nFORGED", shown)
            self.assertNotRegex(shown, "[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e]")
            self.assertNotIn("\nFORGED", shown)

    def test_as_a_frame_has_a_column_for_each_number(self):
        with Session(write_session(self.folder / "a.h5", 120)) as session:
            frame = session.frame()
            self.assertEqual(len(frame), 120)
            self.assertEqual(len(frame.columns), 1 + sum(layout.TABLES["ticks"].values()))
            np.testing.assert_array_equal(frame["p_WT_mm_y"], session.ticks["p_WT_mm"][:, 1])
            np.testing.assert_array_equal(frame["q6_rad"], session.ticks["q_rad"][:, 5])
            np.testing.assert_array_equal(
                frame["theta_rad"], session.ticks["alpha_beta_theta_rad"][:, 2]
            )

    def test_without_an_end_is_incomplete_and_cut_to_the_shortest_column(self):
        # The program died in the middle of a block.
        for longer in (["tick"], ["error_mm"], ["crc32"], [*TICKS]):
            writer = Writer(self.folder / "a.h5")
            writer.ticks(sphere_ticks(300))
            for column in longer:
                dataset = writer.file["ticks"][column]
                dataset.resize(dataset.shape[0] + (1 if column == "crc32" else 100), axis=0)
            writer.file.close()
            with Session(self.folder / "a.h5") as session:
                self.assertFalse(session.complete)
                self.assertIsNone(session.end)
                self.assertEqual(session.ticks["error_mm"].shape, (300,), longer)
                self.assertEqual(session.ticks["q_rad"].shape, (300, 6))

    def test_that_a_killed_program_left_behind_opens(self):
        writer = Writer(self.folder / "a.h5")
        writer.start_swmr()
        writer.ticks(sphere_ticks(300))
        writer.flush()
        data = (
            self.folder / "a.h5"
        ).read_bytes()  # as a kill leaves it: still marked as being written
        (self.folder / "b.h5").write_bytes(data)
        with self.assertRaises(OSError):
            h5py.File(self.folder / "b.h5", "r")
        with Session(self.folder / "b.h5") as session:
            self.assertEqual(session.ticks.rows, 300)
            self.assertFalse(session.complete)

    def test_whose_rows_were_dropped_keeps_their_numbers(self):
        writer = Writer(self.folder / "a.h5")
        writer.ticks(sphere_ticks(100))
        writer.ticks(sphere_ticks(100, first=151))
        writer.end(250)
        with Session(self.folder / "a.h5") as session:
            self.assertEqual(session.ticks["tick"][[99, 100]].tolist(), [100, 151])

    def test_of_no_ticks_says_so_where_it_is_drawn(self):
        from underact.plots import view_of

        writer = Writer(self.folder / "a.h5")
        writer.end(0)
        with Session(self.folder / "a.h5") as session:
            self.assertEqual(session.duration_s, 0)
            with self.assertRaisesRegex(SessionError, "holds no tick"):
                view_of(session)


class TheProgramsOwn(unittest.TestCase):
    def test_session_in_the_repository_is_read(self):
        with Session(ROOT / "tests/golden/session.h5") as session:
            self.assertTrue(session.complete)
            self.assertGreater(session.ticks.rows, 100)
            self.assertEqual(session.ticks["tick"][-1], session.end.tick)
            self.assertEqual(session.scene["underact_scene"], 1)
            turn = np.linalg.norm(session.ticks["quat_WT"], axis=1)
            np.testing.assert_allclose(turn[np.isfinite(turn)], 1, atol=1e-12)
            self.assertEqual(set(session.ticks.meanings), set(layout.TABLES["ticks"]))
            self.assertEqual(session.ticks.units["p_WT_mm"], "mm")


class NoSession(InFolder):
    def refused(self, words: str, kind=SessionError) -> None:
        with self.assertRaisesRegex(kind, words) as raised:
            Session(self.folder / "a.h5")
        self.assertTrue(str(raised.exception).endswith("."))
        self.assertIn("a.h5", str(raised.exception))

    def changed(self, change) -> None:
        with h5py.File(write_session(self.folder / "a.h5", 100), "r+") as file:
            change(file)

    def test_that_is_not_there(self):
        self.refused("cannot be read: No such file", Unreadable)

    def test_that_is_a_pipe_is_refused_at_once(self):
        os.mkfifo(self.folder / "a.h5")
        signal.alarm(20)  # a hang is a failure
        self.refused("not a regular file", Unreadable)
        signal.alarm(0)

    def test_says_what_was_agreed_to(self):
        with Session(write_session(self.folder / "a.h5", 10)) as session:
            self.assertEqual(session.attributes["consent"], "form 2.1")
            self.assertEqual(info_of(session)["consent"], "form 2.1")

    def test_that_is_a_folder(self):
        (self.folder / "a.h5").mkdir()
        self.refused("cannot be read", Unreadable)

    def test_of_another_kind(self):
        for content in (b"", b"tick,time_s\n1,0.001\n", bytes(1000)):
            (self.folder / "a.h5").write_bytes(content)
            self.refused("is not an HDF5 file")

    def test_cut_in_the_middle(self):
        path = write_session(self.folder / "a.h5")
        data = path.read_bytes()
        path.write_bytes(data[: len(data) // 2])
        self.refused("cannot be opened")

    def test_of_somebody_else(self):
        with h5py.File(self.folder / "a.h5", "w") as file:
            file["measurements"] = np.arange(3)
        self.refused("not a session of Underact")

    def test_of_another_version(self):
        self.changed(lambda file: file.attrs.__setitem__("underact_session", 2))
        self.refused("layout 2")

    def test_without_a_table(self):
        self.changed(lambda file: file.__delitem__("markers"))
        self.refused("/markers is missing")

    def test_without_columns(self):
        self.changed(
            lambda file: (file["ticks"].__delitem__("q_rad"), file["ticks"].__delitem__("heat"))
        )
        self.refused("/ticks lacks heat, q_rad")

    def test_without_its_checks(self):
        self.changed(lambda file: file["ticks"].__delitem__("crc32"))
        self.refused("/ticks lacks crc32")

    def test_with_a_column_of_another_width(self):
        def narrow(file):
            del file["ticks/q_rad"]
            file["ticks/q_rad"] = np.zeros((100, 5))

        self.changed(narrow)
        self.refused("q_rad that is not 6 numbers a row")

    def test_without_the_size_of_blocks(self):
        self.changed(lambda file: file["ticks"].attrs.__setitem__("block_rows", 0))
        self.refused("block_rows")

    def test_whose_scene_is_no_json(self):
        writer = Writer(self.folder / "a.h5")
        at, size = writer._text("{no json")
        writer.append(
            "changes",
            {"tick": [1], "revision": [2], "carry": [0], "text_at": [at], "text_bytes": [size]},
        )
        writer.end(0)
        with (
            Session(self.folder / "a.h5") as session,
            self.assertRaisesRegex(SessionError, "not valid JSON"),
        ):
            session.changes

    def test_whose_words_point_nowhere(self):
        writer = Writer(self.folder / "a.h5")
        writer.append("markers", {"tick": [1], "text_at": [10**6], "text_bytes": [5]})
        writer.end(0)
        with (
            Session(self.folder / "a.h5") as session,
            self.assertRaisesRegex(SessionError, "missing in /text"),
        ):
            session.markers


class TheLayout(unittest.TestCase):
    def test_is_that_of_the_pages(self):
        page = (ROOT / "resources/guide/session_columns.md").read_text(encoding="utf-8")
        tables = {part.split("\n", 1)[0]: part for part in page.split("\n## /")[1:]}
        for name, columns in layout.TABLES.items():
            rows = [line for line in tables[name].splitlines() if line.startswith("| `")]
            self.assertEqual([row.split("`")[1] for row in rows], list(columns), name)
        words = (ROOT / "resources/guide/session_file.md").read_text(encoding="utf-8")
        for number, word in enumerate(layout.FAULTS):
            self.assertIn(f"{number} {word}", words)


if __name__ == "__main__":
    unittest.main()
