"""What was run, as a stranger reads it: from a session file alone, with h5py and nothing of ours;
and as the package and its exports say it.
"""

import json
import subprocess
import unittest

import h5py
import numpy as np
from session_writer import write_session
from support import CLI, ROOT, InFolder, works
from underact import Session, export, layout
from underact.info import info_of


class ARecordedRun(InFolder):
    def setUp(self):
        super().setUp()
        self.path = self.folder / "a.h5"
        words = [
            *(CLI, "run", ROOT / "scenes/02_sphere.json", "--hand", "tremor", "--seed", "42"),
            *("--seconds", "0.5", "--fast", "--notes", "mine", "--subject", "S07"),
            *("--record-details", "--record", self.path),
        ]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)

    def test_says_to_a_stranger_what_was_run(self):
        with h5py.File(self.path) as file:
            rows = file["provenance"]
            at, size = rows["text_at"][0], rows["text_bytes"][0]
            said = json.loads(bytes(file["text/bytes"][at : at + size]))
            self.assertEqual(said["run"]["seed"], 42)
            self.assertEqual(said["run"]["hand"]["stiffness_N_per_m"], 300)
            self.assertEqual(said["gains"][0]["kp_N_per_mm"], [0.5, 0.5, 0.5])
            self.assertEqual(said["servo"]["rate_hz"], 1000)
            self.assertEqual(said["arm"]["name"], "omni-thesis")
            position = file["ticks/p_WT_mm"]
            self.assertEqual(position.attrs["unit"], b"mm")
            self.assertEqual(position.attrs["frame"], b"W")
            self.assertGreater(file["clock/unix_ns"][0], 1.5e18)

    def test_has_every_column_of_the_table_with_its_unit_frame_and_meaning(self):
        with Session(self.path) as session:
            tables = {"ticks": session.ticks, "truth": session.truth}
            tables["constraints"] = session.constraints
            for name, table in tables.items():
                for column, described in layout.DESCRIBED[name].items():
                    self.assertEqual(table.units[column], described["unit"], column)
                    self.assertEqual(table.frames[column], described["frame"], column)
                    self.assertEqual(table.meanings[column], described["meaning"], column)
                    self.assertEqual(len(table[column]), 500, column)

    def test_is_a_dictionary_of_the_package(self):
        with Session(self.path) as session:
            self.assertEqual(session.provenance["run"]["hand"]["name"], "tremor")
            self.assertEqual(session.provenance["session"], session.attributes["session_id"])
            self.assertEqual(session.provenance_changes, [])
            self.assertEqual(session.clock["tick"][-1], 500)
            self.assertEqual(info_of(session)["provenance"], session.provenance)
            apart_mm = np.abs(session.truth["p_true_WT_mm"] - session.ticks["p_WT_mm"]).max()
            self.assertLess(apart_mm, 0.2)
            self.assertGreater(apart_mm, 0)

    def test_goes_with_csv(self):
        for made_by in ("cli", "package"):
            out = self.folder / f"{made_by}.csv"
            if made_by == "cli":
                subprocess.run([CLI, "log", "export", self.path, "--out", out], check=True)
            else:
                with Session(self.path) as session:
                    export.csv(session, out)
            said = json.loads((self.folder / f"{made_by}.csv-metadata.json").read_text())
            header = out.read_text().splitlines()[0].split(",")
            columns = said["tableSchema"]["columns"]
            self.assertEqual([one["name"] for one in columns], header)
            units = {one["name"]: one["schema:unitText"] for one in columns}
            self.assertEqual(units["time_s"], "s")
            self.assertEqual(units["force_sent_x_N"], "N")
            self.assertEqual(said["notes"][0]["frames"]["x_mm"], "W")
            self.assertEqual(said["notes"][0]["provenance"]["run"]["seed"], 42)
            self.assertEqual(said["notes"][0]["subject"], "S07")
            self.assertEqual(said["url"], out.name)

    def test_goes_with_parquet(self):
        if not works("pyarrow"):
            return  # of PyPI only
        import pyarrow.parquet

        with Session(self.path) as session:
            export.parquet(session, self.folder / "a.parquet")
            units = session.ticks.units
        schema = pyarrow.parquet.read_schema(self.folder / "a.parquet")
        self.assertEqual(schema.field("p_WT_mm_x").metadata[b"unit"].decode(), units["p_WT_mm"])
        self.assertEqual(schema.field("p_WT_mm_x").metadata[b"frame"], b"W")
        self.assertEqual(schema.field("time_s").metadata[b"unit"], b"s")
        self.assertEqual(schema.metadata[b"underact_session"], b"1")
        self.assertNotIn(b"underact_underact_session", schema.metadata)
        self.assertEqual(json.loads(schema.metadata[b"underact_provenance"])["run"]["seed"], 42)


class AnEarlierSession(InFolder):
    def test_says_nothing_and_opens(self):
        with Session(write_session(self.folder / "a.h5", 10)) as session:
            self.assertEqual(session.provenance, {})
            self.assertEqual(session.provenance_changes, [])
            self.assertEqual(len(session.clock["tick"]), 0)
            self.assertIsNone(session.truth)
            export.csv(session, self.folder / "a.csv")


if __name__ == "__main__":
    unittest.main()
