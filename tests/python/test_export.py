"""What other programs read: CSV, Parquet, MCAP."""

import csv
import json
import math
import os
import subprocess
import unittest
from unittest import mock

import numpy as np
import pandas
from session_writer import Writer, sphere_ticks, write_session
from support import CLI, ROOT, InFolder, command, works
from underact import Session, export


def seven_joints(path):
    """A session of 0.3 s of an arm of seven joints, as the program records it."""
    words = ["run", ROOT / "scenes/38_panda_wall.json", "--hand", "sweep", "--seconds", "0.3"]
    subprocess.run([CLI, *words, "--fast", "--record", path], check=True, stdout=subprocess.DEVNULL)
    return path


class Csv(InFolder):
    def test_has_the_numbers_of_the_session(self):
        path = write_session(self.folder / "a.h5", 250)
        self.assertEqual(
            command("export", path, "--format", "csv", "--out", self.folder / "a.csv")[0], 0
        )
        table = pandas.read_csv(self.folder / "a.csv", float_precision="round_trip")
        wanted = sphere_ticks(250)
        np.testing.assert_array_equal(table[["x_mm", "y_mm", "z_mm"]].to_numpy(), wanted["p_WT_mm"])
        np.testing.assert_array_equal(table["force_sent_z_N"], wanted["force_sent_N"][:, 2])
        np.testing.assert_array_equal(table["theta_rad"], wanted["alpha_beta_theta_rad"][:, 2])
        self.assertEqual(set(table["fault"]), {"none"})

    def test_leaves_what_is_no_number_empty_and_names_faults(self):
        writer = Writer(self.folder / "a.h5")
        ticks = sphere_ticks(2)
        ticks["error_mm"][1] = math.nan
        ticks["fault"][1] = 4
        writer.ticks(ticks)
        writer.end(2)
        with Session(self.folder / "a.h5") as session:
            export.csv(session, self.folder / "a.csv")
        rows = list(csv.DictReader((self.folder / "a.csv").open()))
        self.assertEqual((rows[1]["error_mm"], rows[1]["fault"]), ("", "too_fast"))

    def test_is_what_the_program_records_as_csv(self):
        words = [
            "run",
            ROOT / "scenes/14_circle_influence.json",
            "--hand",
            "tremor",
            "--seconds",
            "1.2",
            "--fast",
        ]
        for name in ("a.h5", "b.csv"):
            subprocess.run(
                [CLI, *words, "--record", self.folder / name], check=True, stdout=subprocess.DEVNULL
            )
        self.assertEqual(
            command(
                "export", self.folder / "a.h5", "--format", "csv", "--out", self.folder / "a.csv"
            )[0],
            0,
        )
        ours, theirs = (
            pandas.read_csv(self.folder / n, float_precision="round_trip")
            for n in ("a.csv", "b.csv")
        )
        self.assertEqual(list(ours.columns), list(theirs.columns))
        same = [
            name for name in ours.columns if name not in ("tick_us", "lateness_us")
        ]  # another run, another time
        pandas.testing.assert_frame_equal(
            ours[same], theirs[same], check_dtype=False, check_exact=True
        )

    def test_has_the_joints_beyond_the_sixth_of_an_arm_that_has_them(self):
        scene = str(ROOT / "scenes/38_panda_wall.json")
        words = ["run", scene, "--hand", "sweep", "--seconds", "0.3", "--fast"]
        for name in ("a.h5", "b.csv"):
            subprocess.run(
                [CLI, *words, "--record", self.folder / name], check=True, stdout=subprocess.DEVNULL
            )
        with Session(self.folder / "a.h5") as session:
            self.assertEqual(session.more_joints().shape, (300, 2))
            np.testing.assert_array_equal(session.frame()["q7_rad"], session.more_joints()[:, 0])
            export.csv(session, self.folder / "a.csv")
        ours, theirs = (pandas.read_csv(self.folder / name) for name in ("a.csv", "b.csv"))
        self.assertEqual(list(ours.columns), list(theirs.columns))
        np.testing.assert_array_equal(ours["q7_rad"], theirs["q7_rad"])
        self.assertGreater(ours["q7_rad"].abs().min(), 0.1)
        about = json.loads((self.folder / "a.csv-metadata.json").read_text())
        self.assertEqual(about["url"], "a.csv")
        self.assertEqual(about["tableSchema"]["columns"][-2]["name"], "q7_rad")

    def test_is_its_owners_alone(self):
        umask = os.umask(0)
        try:
            with Session(write_session(self.folder / "a.h5", 10)) as session:
                export.csv(session, self.folder / "a.csv")
        finally:
            os.umask(umask)
        self.assertEqual((self.folder / "a.csv").stat().st_mode & 0o777, 0o600)

    def test_that_cannot_be_written_ends_with_4(self):
        path = write_session(self.folder / "a.h5", 100)
        status, _, error = command(
            "export", path, "--format", "csv", "--out", self.folder / "no" / "a.csv"
        )
        self.assertEqual(status, 4)
        self.assertIn("No such file", error)


class Parquet(InFolder):
    def test_says_how_to_get_what_it_takes(self):
        path = write_session(self.folder / "a.h5", 100)
        with mock.patch.dict("sys.modules", {"pyarrow": None}):
            status, _, error = command(
                "export", path, "--format", "parquet", "--out", self.folder / "a.parquet"
            )
        self.assertEqual(status, 5)
        self.assertIn("python3 -m pip install 'pyarrow<17'", error)
        self.assertFalse((self.folder / "a.parquet").exists())

    def test_holds_the_frame_where_pyarrow_is_there(self):
        if not works("pyarrow"):
            return  # of PyPI only; the test above says what happens then
        import pyarrow.parquet

        with Session(write_session(self.folder / "a.h5", 250)) as session:
            export.parquet(session, self.folder / "a.parquet")
            pandas.testing.assert_frame_equal(
                pandas.read_parquet(self.folder / "a.parquet"), session.frame()
            )
            stored = pyarrow.parquet.read_schema(self.folder / "a.parquet").metadata
            self.assertEqual(json.loads(stored[b"underact_scene"]), session.scene)


class Mcap(InFolder):
    def test_says_how_to_get_what_it_takes(self):
        path = write_session(self.folder / "a.h5", 100)
        with mock.patch.dict("sys.modules", {"mcap": None, "mcap.writer": None}):
            status, _, error = command(
                "export", path, "--format", "mcap", "--out", self.folder / "a.mcap"
            )
        self.assertEqual(status, 5)
        self.assertIn("python3 -m pip install mcap", error)

    def test_messages_come_in_the_order_of_time(self):
        writer = Writer(self.folder / "a.h5")
        writer.ticks(sphere_ticks(2000))
        writer.mark(1501, "late")
        writer.fault(501, 4, 2.3, 1.0)
        writer.end(2000)
        with Session(self.folder / "a.h5") as session:
            messages = list(export._messages(session))
            self.assertEqual(len(messages), 2002)
            times = [time_ns for time_ns, _, _ in messages]
            self.assertEqual(times, sorted(times))
            events = [(time_ns, topic) for time_ns, topic, _ in messages if topic != "/tick"]
            self.assertEqual(events, [(501_000_000, "/faults"), (1_501_000_000, "/markers")])
            self.assertEqual(set(messages[0][2]), set(session.ticks))

    def test_messages_have_the_joints_beyond_the_sixth_of_an_arm_that_has_them(self):
        with Session(seven_joints(self.folder / "a.h5")) as session:
            ticks = [message for _, topic, message in export._messages(session) if topic == "/tick"]
            self.assertEqual([one["q_rad"] for one in ticks], session.ticks["q_rad"].tolist())
            self.assertEqual([one["q_more_rad"] for one in ticks], session.more_joints().tolist())
            self.assertGreater(min(abs(one["q_more_rad"][0]) for one in ticks), 0.1)
            schema = export._tick_schema(session)
            self.assertEqual(list(schema), ["time_s", *ticks[0]])
            self.assertEqual((schema["q_more_rad"]["minItems"], ticks[0]["q_more_rad"][1]), (2, 0))
            self.assertEqual(schema["q_more_rad"]["items"]["unit"], "rad")

    def test_of_six_joints_says_nothing_of_more(self):
        with Session(write_session(self.folder / "a.h5", 100)) as session:
            self.assertEqual(list(export._tick_schema(session)), ["time_s", *session.ticks])
            self.assertEqual(list(next(export._messages(session))[2]), list(session.ticks))

    def test_of_seven_joints_is_read_back_where_mcap_is_there(self):
        if not works("mcap.reader"):
            return  # of PyPI only; the tests above say what it is given
        from mcap.reader import make_reader

        with Session(seven_joints(self.folder / "a.h5")) as session:
            export.mcap(session, self.folder / "a.mcap")
            six, more = session.ticks["q_rad"], session.more_joints()
        with open(self.folder / "a.mcap", "rb") as file:
            messages = [
                (json.loads(s.data), json.loads(m.data))
                for s, c, m in make_reader(file).iter_messages()
                if c.topic == "/tick"
            ]
        said = [one["q_rad"] + one["q_more_rad"] for _, one in messages]
        np.testing.assert_array_equal(said, np.hstack([six, more]))
        self.assertEqual(set(messages[0][0]["properties"]), set(messages[0][1]))

    def test_is_read_back_where_mcap_is_there(self):
        if not works("mcap.reader"):
            return  # of PyPI only; the test above says what happens then
        from mcap.reader import make_reader

        with Session(write_session(self.folder / "a.h5", 2000)) as session:
            export.mcap(session, self.folder / "a.mcap")
            error_mm = session.ticks["error_mm"]
        with open(self.folder / "a.mcap", "rb") as file:
            messages = [
                (c.topic, s.encoding, json.loads(m.data))
                for s, c, m in make_reader(file).iter_messages()
            ]
        self.assertEqual({encoding for _, encoding, _ in messages}, {"jsonschema"})
        self.assertEqual(
            [message["error_mm"] for topic, _, message in messages if topic == "/tick"],
            error_mm.tolist(),
        )
        self.assertEqual(
            [message["label"] for topic, _, message in messages if topic == "/markers"][0][:7],
            "pressed",
        )


class Names(InFolder):
    """Files are written where they were named, or not at all."""

    def test_a_link_a_pipe_and_the_session_itself_are_refused_at_once(self):
        path = write_session(self.folder / "a.h5", 50)
        mine = self.folder / "mine.txt"
        mine.write_text("mine")
        before = path.read_bytes()
        for name in ("link.csv", "b.csv-metadata.json", "link.png"):
            (self.folder / name).symlink_to(mine)
        for name in ("pipe.csv", "c.csv-metadata.json", "pipe.png"):
            os.mkfifo(self.folder / name)
        for name in ("link.csv", "b.csv", "pipe.csv", "c.csv", "a.h5"):
            code, _, words = command("export", path, "--out", self.folder / name)
            self.assertEqual(code, 4, name)
            self.assertIn(name.split(".")[0], words)
        for name in ("link.png", "pipe.png"):
            out = self.folder / name
            self.assertEqual(command("plot", path, "--kind", "error", "--out", out)[0], 4, name)
        self.assertEqual((mine.read_text(), path.read_bytes()), ("mine", before))
        self.assertFalse((self.folder / "b.csv").exists() or (self.folder / "c.csv").exists())

    def test_an_export_is_replaced_and_keeps_its_rights(self):
        path, out = write_session(self.folder / "a.h5", 50), self.folder / "A.CSV"
        out.write_text("older")
        out.chmod(0o640)
        self.assertEqual(command("export", path, "--out", out)[0], 0)
        self.assertEqual((out.stat().st_mode & 0o777, out.read_text()[:4]), (0o640, "tick"))

    def test_a_name_of_another_format_is_wrong_usage(self):
        path = write_session(self.folder / "a.h5", 50)
        for form, name in (("csv", "a.Parquet"), ("mcap", "a.csv"), ("csv", "a.html")):
            out = self.folder / name
            self.assertEqual(command("export", path, "--format", form, "--out", out)[0], 2, name)
            self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
