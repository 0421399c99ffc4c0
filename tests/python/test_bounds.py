"""A stranger's file takes no more memory and time than its own bytes are good for."""

import resource
import signal
import unittest
import zlib

import h5py
import numpy as np
from session_writer import Writer, sphere_ticks, write_session
from support import InFolder, command
from underact import DamagedSession, Session, SessionError, layout
from underact.info import info_of
from underact.plots import draw, view_of

MAX_BYTES = 2 << 30  # of addresses, most of which libraries take


def replaced(table: h5py.Group, column: str, rows: int, kind: str, chunk: int, **more) -> None:
    del table[column]
    table.create_dataset(column, (rows,), kind, maxshape=(None,), chunks=(chunk,), **more)


def packed(path, out, **more):
    """A copy as h5repack makes it."""
    with h5py.File(path, "r") as one, h5py.File(out, "w", libver=("v110", "v110")) as other:
        other.attrs.update(one.attrs)
        for name, group in one.items():
            other.create_group(name).attrs.update(group.attrs)
            for column, data in group.items():
                settings = {"maxshape": data.maxshape, "chunks": data.chunks, **more}
                other[name].create_dataset(column, data=data[:], **settings)
    return out


class Bounded(InFolder):
    def setUp(self):
        super().setUp()
        before = resource.getrlimit(resource.RLIMIT_AS)
        self.addCleanup(resource.setrlimit, resource.RLIMIT_AS, before)
        resource.setrlimit(resource.RLIMIT_AS, (MAX_BYTES, before[1]))
        signal.alarm(120)  # a hang is a failure
        self.addCleanup(signal.alarm, 0)
        self.path = write_session(self.folder / "a.h5", 250)

    def change(self, change) -> None:
        with h5py.File(self.path, "r+", libver=("v110", "v110")) as file:
            change(file)

    def refused(self, words: str) -> None:
        with self.assertRaisesRegex(SessionError, words):
            with Session(self.path) as session:
                session.frame()
                info_of(session)


class ATable(Bounded):
    def endless_faults(self, file: h5py.File, **more) -> None:
        for column, kind in (("tick", "<i8"), ("kind", "u1"), ("seen", "<f8"), ("allowed", "<f8")):
            replaced(file["faults"], column, 1 << 36, kind, 64)
        replaced(file["faults"], "from_servo", 1 << 36, "u1", 64)
        replaced(file["faults"], "crc32", 1 << 36, "<u4", 64, **more)

    def test_of_more_rows_than_the_file_has_bytes_for_is_refused(self):
        self.change(self.endless_faults)
        self.refused("/faults says that it has 68719476736 rows")

    def test_whose_checksums_are_a_fill_value_is_refused(self):
        self.change(lambda file: self.endless_faults(file, fillvalue=zlib.crc32(bytes(26))))
        self.refused("column crc32 that is laid out otherwise")

    def test_of_endless_ticks_is_refused(self):
        def change(file):
            for column in file["ticks"].values():
                column.resize(1 << 36, axis=0)

        self.change(change)
        self.refused("/ticks says that it has")
        for words in (
            ("plot", "--kind", "error", "--out", "a.png"),
            ("export", "--format", "csv", "--out", "a.csv"),
        ):
            out = self.folder / words[-1]
            status, _, error = command(words[0], self.path, *words[1:-1], out)
            self.assertEqual(status, 1)
            self.assertIn("more than the file has bytes for", error)

    def test_of_blocks_that_it_never_has_is_refused(self):
        for table, rows in (("ticks", 200_001), ("faults", 2), ("text", 128), ("markers", 10**6)):
            with self.subTest(table):
                self.path = write_session(self.folder / "a.h5", 250)
                change = lambda file: file[table].attrs.__setitem__("block_rows", np.int64(rows))
                self.change(change)
                self.refused(f"/{table} says that a block has {rows} rows")

    def test_that_grows_beyond_the_file_while_it_is_followed_gives_no_more(self):
        writer = Writer(self.folder / "b.h5")
        writer.start_swmr()
        writer.ticks(sphere_ticks(200))
        writer.flush()
        self.addCleanup(writer.file.close)
        with Session(self.folder / "b.h5") as session:
            for column in writer.file["ticks"].values():
                column.resize(1 << 36, axis=0)
                column.flush()
            session.ticks.refresh()
            self.assertLess(session.ticks.common_rows(), 10_000)

    def test_of_too_many_marks_is_refused(self):
        def change(file):
            marks, rows = file["markers"], layout.MAX_ROWS["markers"] + 1
            for column in marks:
                marks[column].resize(rows, axis=0)
                marks[column][:] = zlib.crc32(bytes(24)) if column == "crc32" else 0

        self.change(change)
        with Session(self.path) as session, self.assertRaisesRegex(SessionError, "at most 65536"):
            session.markers

    def test_laid_out_in_another_way_is_refused(self):
        for what, kind, more in (
            ("chunks", "<i8", {"chunks": (1 << 24,)}),
            ("type", "<i4", {"chunks": (100,)}),
            ("filter", "<i8", {"chunks": (100,), "fletcher32": True}),
            ("fixed", "<i8", {"maxshape": (250,), "chunks": (100,)}),
        ):
            with self.subTest(what):
                self.path = write_session(self.folder / "a.h5", 250)

                def change(file):
                    data = file["ticks/tick"][:]
                    del file["ticks/tick"]
                    settings = {"maxshape": (None,), **more}
                    file["ticks"].create_dataset("tick", data=data.astype(kind), **settings)

                self.change(change)
                self.refused("column tick that is laid out otherwise")


class WhatIsPacked(Bounded):
    def test_comes_back_as_it_was(self):
        for index, more in enumerate(({"shuffle": True, "compression": 1}, {"compression": 9})):
            path = packed(self.path, self.folder / f"{index}.h5", **more)
            with Session(self.path) as session, Session(path) as other:
                self.assertTrue(session.frame().equals(other.frame()))
                self.assertEqual(session.changes, other.changes)
                self.assertEqual(session.markers, other.markers)

    def test_is_unpacked_to_a_chunk_and_no_further(self):
        packer = zlib.compressobj(9)
        bomb = packer.compress(b"") + packer.flush(zlib.Z_FULL_FLUSH)
        bomb += 32 * (packer.compress(bytes(1 << 24)) + packer.flush(zlib.Z_FULL_FLUSH))
        self.path = packed(self.path, self.folder / "b.h5", compression=9)
        self.change(lambda file: file["ticks/tick"].id.write_direct_chunk((0,), bomb))
        before_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        with Session(self.path) as session, self.assertRaises(DamagedSession):
            session.ticks["tick"]
        grown_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before_kib
        self.assertLess(grown_kib, 100 << 10)  # and not half a gibibyte


class TheWords(Bounded):
    def flood(self, size: int, marks: int) -> None:
        """Labels of zeros that nothing stands behind, with right checksums."""

        def change(file):
            rows = marks * size
            replaced(file["text"], "bytes", rows, "u1", 1024, compression=1)
            replaced(file["text"], "crc32", rows // 64, "<u4", 64, compression=1)
            file["text/crc32"][:] = zlib.crc32(bytes(64))
            table = file["markers"]
            for column in table:
                table[column].resize(marks, axis=0)
            table["tick"][:], table["text_bytes"][:] = 1, size
            table["text_at"][:] = np.arange(marks) * size
            for row in range(marks):
                crc = 0
                for column in ("tick", "text_at", "text_bytes"):
                    crc = zlib.crc32(table[column][row].tobytes(), crc)
                table["crc32"][row] = crc

        self.change(change)

    def test_of_a_label_are_64_kib_at_most(self):
        self.flood((64 << 10) + 64, 2)
        with Session(self.path) as session, self.assertRaises(DamagedSession) as raised:
            session.markers
        self.assertEqual((raised.exception.table, raised.exception.spans), ("markers", [(1, 1)]))
        with Session(self.path, damaged="skip") as session:
            self.assertEqual([mark.label for mark in session.markers], ["?", "?"])
        self.flood(64 << 10, 2)
        with Session(self.path) as session:
            self.assertEqual([len(mark.label) for mark in session.markers], [64 << 10] * 2)

    def test_of_all_labels_are_16_mib_at_most(self):
        self.flood(64 << 10, 257)
        with Session(self.path, damaged="skip") as session:
            labels = [mark.label for mark in session.markers]
        self.assertEqual([len(label) for label in labels], [64 << 10] * 256 + [1])
        self.assertEqual(labels[-1], "?")

    def test_of_a_scene_may_nest_no_deeper_than_python_goes(self):
        writer = Writer(self.folder / "b.h5")
        at, size = writer._text("[" * 100_000)
        row = {"tick": [1], "revision": [2], "carry": [0], "text_at": [at], "text_bytes": [size]}
        writer.append("changes", row)
        writer.end(0)
        with Session(self.folder / "b.h5") as session, self.assertRaisesRegex(SessionError, "JSON"):
            session.changes

    def test_of_an_attribute_are_a_mebibyte_at_most(self):
        def change(file):
            kind = h5py.h5t.C_S1.copy()
            kind.set_size(2 << 20)
            space = h5py.h5s.create(h5py.h5s.SCALAR)
            h5py.h5a.create(file.id, b"longest", kind, space).write(np.array(b"x", "S2097152"))
            file.attrs["list"], file.attrs["any_length"] = np.arange(9), "words"
            file.attrs["rate_hz"] = np.int64(-1)

        self.change(change)
        with Session(self.path) as session:
            found = session.attributes
            self.assertEqual({"longest", "list", "any_length"} & set(found), set())
            self.assertEqual(found["device"], "simulated arm")
            self.assertAlmostEqual(view_of(session).rate_hz, 1000.0, 6)


class APlot(Bounded):
    def test_of_a_crowd_of_marks_says_how_many_it_draws(self):
        writer = Writer(self.folder / "b.h5")
        writer.ticks(sphere_ticks(300))
        for tick in range(1, 300):
            writer.mark(tick, "$x$ is no formula, and $ is none")
        writer.end(300)
        with Session(self.folder / "b.h5") as session:
            view = view_of(session)
        figure = draw("error", view)
        self.assertEqual(figure.axes[0].get_xlabel(), "time [s], 200 of 299 markers and faults")
        self.assertLess(len(figure.axes[0].texts), 201)
        figure.canvas.draw()

    def test_of_what_is_no_scene_is_a_sentence(self):
        writer = Writer(
            self.folder / "b.h5", scene={"title": "?", "constraints": [{"type": "box"}]}
        )
        writer.ticks(sphere_ticks(50))
        writer.end(50)
        out = self.folder / "a.png"
        status, _, error = command("plot", self.folder / "b.h5", "--kind", "path", "--out", out)
        self.assertEqual(status, 1)
        self.assertIn("cannot be drawn", error)


if __name__ == "__main__":
    unittest.main()
