"""Makes the figures: runs the programs, draws, checks, and writes the page and figures.json."""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

from matplotlib.figure import Figure

from .. import style
from ..errors import SessionError
from ..plots.view import View, footer_of, view_of
from ..session import Session
from . import appendix_b, chapter5, eight
from .catalogue import CATALOGUE, Entry
from .number import Number
from .page import page
from .programs import Programs


def resources() -> Path:
    """The folder of the figures' scenes: in the source tree, or beside the installed package."""
    here = Path(__file__).resolve()
    for folder in (here.parents[4] / "resources" / "figures", here.parents[3] / "figures"):
        if folder.is_dir():
            return folder
    raise SessionError(
        "The figures' scenes are not installed: there is no folder figures beside this package."
    )


class Maker:
    """Makes one figure after the other into a folder; runs that several figures share are run
    once.
    """

    def __init__(self, programs: Programs, out: Path):
        self.programs, self.out, self.source = programs, out, resources()
        self._views: dict[str, View] = {}

    def make(self, entry: Entry) -> dict:
        """Makes a figure; gives its row of figures.json. A program that fails makes the figure
        fail, not the others.
        """
        row = {
            "figure": entry.key,
            "title": entry.title,
            "caption": entry.caption,
            "kind": entry.kind,
        }
        row.update(
            {
                "pictures": [],
                "numbers": [],
                "left_out": "",
                "problem": "",
                "scene": "",
                "hand": "",
                "session": "",
            }
        )
        try:
            if entry.scene:
                row["scene"] = self._copy(f"{entry.scene}.json")
            getattr(self, f"_{entry.kind}")(entry, row)
        except SessionError as error:
            row["problem"] = str(error)
        row["passed"] = not row["problem"] and all(number["passed"] for number in row["numbers"])
        return row

    def _copy(self, name: str) -> str:
        to = self.out / "scenes" / name
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(self.source / name, to)
        return f"scenes/{name}"

    def _keep(self, entry: Entry, row: dict, figure: Figure, numbers: list[Number]) -> None:
        stem = "figure_" + entry.key.replace(".", "_")
        for ending in style.FORMATS:
            style.save(figure, self.out / f"{stem}.{ending}")
            row["pictures"].append(f"{stem}.{ending}")
        row["numbers"] = [number.as_dict() for number in numbers]

    def _run(self, entry: Entry, row: dict) -> None:
        row["hand"] = self._copy(f"{entry.scene}_hand.json")
        row["session"] = f"sessions/{entry.scene}.h5"
        if entry.scene not in self._views:
            record = self.out / row["session"]
            record.parent.mkdir(parents=True, exist_ok=True)
            record.unlink(missing_ok=True)
            self.programs.run(
                self.out / row["scene"], self.out / row["hand"], entry.seconds, record
            )
            with Session(record) as session:
                if not session.complete:
                    raise SessionError(f"{record.name} did not end in order.")
                words = footer_of(session.attributes, "seed 1")
                self._views[entry.scene] = view_of(session, footer=words)
        view = self._views[entry.scene]
        self._keep(entry, row, style.styled(entry.draw)(view), entry.check(view))

    def _target(self, entry: Entry, row: dict) -> None:
        answer = self.programs.answers(
            ["target", str(self.out / row["scene"])], [chapter5.angle_question()]
        )[0]
        self._keep(entry, row, style.styled(entry.draw)(answer), entry.check(answer))

    def _ik(self, entry: Entry, row: dict) -> None:
        answer = eight.solve(self.programs)
        self._keep(entry, row, style.styled(entry.draw)(answer), entry.check(answer))

    def _step(self, entry: Entry, row: dict) -> None:
        row["caption"] += " " + appendix_b.source(self.programs)
        self._keep(entry, row, style.styled(entry.draw)(self.programs), entry.check(self.programs))

    def _view(self, entry: Entry, row: dict) -> None:
        name = f"figure_{entry.key.replace('.', '_')}.png"
        row["left_out"] = self.programs.picture(self.out / row["scene"], self.out / name)
        if not row["left_out"]:
            row["pictures"].append(name)


def _chosen(only: list[str] | None) -> list[Entry]:
    if only is None:
        return list(CATALOGUE)
    known = [entry.key for entry in CATALOGUE]
    strange = [key for key in only if key not in known]
    if strange:
        raise ValueError(f"There is no figure {', '.join(strange)}; there are {', '.join(known)}.")
    return [entry for entry in CATALOGUE if entry.key in only]


def _tell(number: int, entries: list[Entry], lines: bool) -> None:
    """Says on standard error which figure is made now: to a person on a terminal, or to a program,
    a line each.
    """
    key = entries[number - 1].key
    if lines:
        words = json.dumps({"number": number, "of": len(entries), "figure": key}) + "\n"
    elif sys.stderr.isatty():
        words = f"\r{number} of {len(entries)}: figure {key}   "
    else:
        return
    print(words, end="", file=sys.stderr, flush=True)


def make(
    cli: Path,
    window: Path | None,
    out: Path,
    only: list[str] | None = None,
    progress_lines: bool = False,
) -> int:
    """Makes the figures (all, or those named) into the folder `out`.

    Gives 0, or 1 where an assertion fails.

    Writes NAME.png, .svg and .pdf of each, scenes/ and sessions/, index.html and figures.json.
    Progress goes to standard error where that is a terminal, or with `progress_lines` as one JSON
    object a line; what failed always does.
    """
    entries = _chosen(only)
    out = Path(out).absolute()
    out.mkdir(parents=True, exist_ok=True)
    maker = Maker(Programs(Path(cli).absolute(), Path(window).absolute() if window else None), out)
    rows = []
    for index, entry in enumerate(entries, start=1):
        _tell(index, entries, progress_lines)
        rows.append(maker.make(entry))
    if sys.stderr.isatty() and not progress_lines:
        print(file=sys.stderr)
    (out / "figures.json").write_text(
        json.dumps(rows, indent=1, ensure_ascii=False) + "\n", encoding="utf-8"
    )
    (out / "index.html").write_text(page(rows), encoding="utf-8")
    for row in rows:
        for words in _failures(row):
            print(f"Figure {row['figure']}: {words}", file=sys.stderr)
    return 0 if all(row["passed"] for row in rows) else 1


def _failures(row: dict) -> list[str]:
    failed = [number for number in row["numbers"] if not number["passed"]]
    words = [
        f"{n['what']} is {n['measured']} {n['unit']}, and should be {n['expected']} within "
        f"{n['tolerance']}."
        for n in failed
    ]
    return words + [text for text in (row["problem"], row["left_out"]) if text]
