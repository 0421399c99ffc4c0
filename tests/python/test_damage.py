"""A byte that changed on the way is found, and the ticks that it spans are named."""

import time
import unittest

import h5py
import numpy as np
from session_writer import TICKS, Writer, sphere_ticks, write_session
from support import SOAK, InFolder, command
from underact import DamagedSession, Session, SessionError
from underact.info import info_of


def flip(path, dataset: str, row: int) -> None:
    """Changes one bit of the first number of a row, behind the library's back."""
    with h5py.File(path, "r") as file:
        data = file[dataset]
        chunk = row // data.chunks[0]
        info = data.id.get_chunk_info_by_coord((chunk * data.chunks[0],) + (0,) * (data.ndim - 1))
        row_bytes = data.dtype.itemsize * int(np.prod(data.shape[1:], initial=1))
        at = info.byte_offset + (row - chunk * data.chunks[0]) * row_bytes
    with open(path, "r+b") as file:
        file.seek(at)
        byte = file.read(1)[0]
        file.seek(at)
        file.write(bytes([byte ^ 1]))


class ADamagedBlock(InFolder):
    def setUp(self):
        super().setUp()
        self.path = write_session(self.folder / "a.h5", 1050)

    def spans(self) -> list:
        with Session(self.path) as session, self.assertRaises(DamagedSession) as raised:
            session.ticks["error_mm"]
        self.assertEqual(raised.exception.table, "ticks")
        return raised.exception.spans

    def test_is_found_in_every_column(self):
        for column in TICKS:
            with self.subTest(column):
                flip(self.path, f"ticks/{column}", 342)
                self.assertEqual(self.spans(), [(301, 400)])
                flip(self.path, f"ticks/{column}", 342)
        with Session(self.path) as session:  # all put right again
            self.assertEqual(session.ticks.rows, 1050)

    def test_at_either_end_spans_its_own_ticks(self):
        flip(self.path, "ticks/tick", 0)
        flip(self.path, "ticks/tick", 1049)
        self.assertEqual(self.spans(), [(1, 100), (1001, 1050)])

    def test_beside_another_is_one_span(self):
        flip(self.path, "ticks/cut_N", 250)
        flip(self.path, "ticks/heat", 350)
        self.assertEqual(self.spans(), [(201, 400)])

    def test_of_the_checks_themselves_counts(self):
        flip(self.path, "ticks/crc32", 4)
        self.assertEqual(self.spans(), [(401, 500)])

    def test_is_told_as_ticks_not_rows(self):
        writer = Writer(self.path)
        for first in (5001, 5101, 5301):  # 100 ticks were dropped before the last block
            writer.ticks(sphere_ticks(100, first))
        writer.end(5400)
        flip(self.path, "ticks/q_rad", 120)
        self.assertEqual(self.spans(), [(5101, 5300)])

    def test_can_be_left_out(self):
        flip(self.path, "ticks/p_WT_mm", 342)
        with Session(self.path, damaged="skip") as session:
            self.assertEqual(session.ticks.rows, 950)
            self.assertEqual(session.ticks.damage, [(300, 400)])
            self.assertEqual(session.ticks["tick"][[299, 300]].tolist(), [300, 401])
            self.assertEqual(len(session.frame()), 950)
            self.assertEqual(session.markers[0].tick, 500)

    def test_of_the_words_is_told(self):
        flip(self.path, "text/bytes", 3)
        with Session(self.path) as session, self.assertRaises(DamagedSession) as raised:
            session.scene
        self.assertEqual(raised.exception.table, "text")

    def test_ends_a_command_with_1_and_a_sentence(self):
        flip(self.path, "ticks/q_rad", 342)
        status, out, error = command("info", self.path)
        self.assertEqual((status, out), (1, ""))
        self.assertIn("ticks 301 to 400", error)
        status, out, _ = command("info", self.path, "--damaged", "skip", "--json")
        self.assertEqual(status, 0)
        self.assertIn('"damaged_rows": 100', out)


class AnyFile(InFolder):
    """Whatever bytes change: the session, or a sentence; never another error, never for ever."""

    def judge(self, data: bytes, cases: int, seed: int) -> None:
        random = np.random.default_rng(seed)
        path = self.folder / "b.h5"
        for case in range(cases):
            changed = bytearray(data)
            for at in random.integers(0, len(data), random.choice([1, 3, 30])):
                changed[at] = random.integers(0, 256)
            for at in random.integers(
                0, 30_000, random.choice([0, 1, 3])
            ):  # where the tables are described
                changed[at] = random.integers(0, 256)
            path.write_bytes(changed[: random.integers(len(data))] if case % 10 == 0 else changed)
            began_s = time.monotonic()
            try:
                with Session(path, damaged=("raise", "skip")[case % 2]) as session:
                    info_of(session)
                    session.frame()
                    list(session.follow(0.01, timeout_s=0.02))
            except SessionError as error:
                self.assertRegex(str(error), r"[.)]$")
            self.assertLess(time.monotonic() - began_s, 20, f"case {case} of seed {seed}")

    def test_that_was_closed(self):
        path = write_session(self.folder / "a.h5", 250)
        self.judge(path.read_bytes(), 1000 if SOAK else 60, 20070601)

    def test_that_a_killed_program_left(self):
        writer = Writer(self.folder / "a.h5")
        writer.start_swmr()
        writer.ticks(sphere_ticks(250))
        writer.flush()
        data = (self.folder / "a.h5").read_bytes()
        writer.file.close()
        self.judge(data, 1000 if SOAK else 60, 20070602)


class AStrangersFile(InFolder):
    """Its tables and columns are in itself, or it is refused: a link may lead to any file."""

    def refused(self, change) -> None:
        path = write_session(self.folder / "a.h5", 250)
        write_session(self.folder / "b.h5", 250)
        with h5py.File(path, "r+") as file:
            change(file)
        with self.assertRaises(SessionError):
            with Session(path) as session:
                session.frame()

    def test_that_borrows_a_column_by_a_link(self):
        def change(file):
            del file["ticks/q_rad"]
            file["ticks/q_rad"] = h5py.ExternalLink("b.h5", "/ticks/q_rad")

        self.refused(change)

    def test_that_borrows_a_table_by_a_link(self):
        def change(file):
            del file["ticks"]
            file["ticks"] = h5py.ExternalLink("b.h5", "/ticks")

        self.refused(change)

    def test_that_borrows_the_numbers_of_a_column(self):
        def change(file):
            shape = file["ticks/q_rad"].shape
            del file["ticks/q_rad"]
            layout = h5py.VirtualLayout(shape=shape, dtype="<f8")
            layout[:] = h5py.VirtualSource("b.h5", "/ticks/q_rad", shape=shape)
            file["ticks"].create_virtual_dataset("q_rad", layout)

        self.refused(change)


if __name__ == "__main__":
    unittest.main()
