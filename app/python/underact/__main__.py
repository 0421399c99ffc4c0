"""The command line: `python3 -m underact info|plot|export|lab|figures`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from .errors import MissingLibrary, SessionError, Unreadable, drawing_errors, missing, printed

WELL, BAD_INPUT, USAGE, FILE, LIBRARY = 0, 1, 2, 4, 5


def _ending_of(kind: str, out: Path, many: bool) -> Path:
    """Where a plot goes: --out itself, or with `all` its name with the kind before the ending."""
    return out.with_name(f"{out.stem}_{kind}{out.suffix}") if many else out


def plot(options: argparse.Namespace) -> int:
    """Draws one kind of plot, or all, into files."""
    from .session import Session

    with Session(options.file, options.damaged) as session:
        from . import plots, style  # half a second, for no file that is refused

        if options.out.suffix.lower().lstrip(".") not in style.FORMATS:
            raise ValueError(f"--out {options.out}: a picture ends in .png, .svg or .pdf.")
        kinds = list(plots.KINDS) if options.kind == "all" else [options.kind]
        view = plots.view_of(session, options.from_s, options.to_s)
    for kind in kinds:
        figure = plots.draw(kind, view, options.width)
        with drawing_errors():
            out = _ending_of(kind, options.out, len(kinds) > 1)
            style.save(figure, out, view.session_id)
    return WELL


def export(options: argparse.Namespace) -> int:
    """Writes the ticks in another format."""
    from . import export as forms
    from .session import Session

    with Session(options.file, options.damaged) as session:
        forms.FORMATS[forms.form_of(options.out, options.format)](session, options.out)
    return WELL


def info(options: argparse.Namespace) -> int:
    """Prints what a file holds."""
    from .info import print_info
    from .session import Session

    with Session(options.file, options.damaged) as session:
        print_info(session, options.json)
    return WELL


def figures(options: argparse.Namespace) -> int:
    """Remakes the thesis's figures."""
    from .figures.make import make

    only = [key.strip() for key in options.only.split(",")] if options.only else None
    return make(options.cli, options.window, options.out, only, options.progress_lines)


def lab(options: argparse.Namespace) -> int:
    """Draws what the lab measured."""
    from .lab import stability, trade

    options.out.mkdir(parents=True, exist_ok=True)
    draw_all = {"stability": stability.draw_all, "trade": trade.draw_all}[options.what]
    for path in draw_all(options.tables, options.out, options.width):
        print(path)
    return WELL


def parser() -> argparse.ArgumentParser:
    """The options of all commands."""
    top = argparse.ArgumentParser(
        "underact", description="Reads, plots and exports sessions of Underact."
    )
    commands = top.add_subparsers(dest="command", required=True)

    def command(name: str, run, words: str, file: bool = True) -> argparse.ArgumentParser:
        one = commands.add_parser(name, help=words, description=words)
        one.set_defaults(run=run)
        if file:
            one.add_argument("file", type=Path, help="a session file")
            one.add_argument(
                "--damaged",
                choices=("raise", "skip"),
                default="raise",
                help="skip: leave damaged ticks out",
            )
        return one

    one = command("info", info, "Shows what a session file contains.")
    one.add_argument("--json", action="store_true", help="as one JSON object")

    one = command("plot", plot, "Plots a session.")
    kinds = "error force displacement-force path angles joints energy spectrum lateness all".split()
    one.add_argument("--kind", choices=kinds, required=True)
    one.add_argument(
        "--out", type=Path, required=True, help=".png, .svg or .pdf; with --kind all one file each"
    )
    one.add_argument(
        "--width", type=float, default=7.0, help="inches: 3.5 (a column) or 7 (a page)"
    )
    one.add_argument("--from", dest="from_s", type=float, help="s since the first tick")
    one.add_argument("--to", dest="to_s", type=float, help="s since the first tick")

    one = command("export", export, "Writes the ticks of a session in another format.")
    one.add_argument("--format", choices=("csv", "parquet", "mcap"))
    one.add_argument("--out", type=Path, required=True)

    one = command("lab", lab, "Plots the tables of `underact-cli lab`.", file=False)
    one.add_argument("what", choices=("stability", "trade"))
    one.add_argument("--tables", type=Path, required=True, help="the folder of the tables")
    one.add_argument("--out", type=Path, required=True, help="a folder; created if missing")
    one.add_argument("--width", type=float, default=7.0, help="inches: 3.5 or 7 (a page)")

    one = command(
        "figures",
        figures,
        "Remakes the figures of the thesis, and checks what they show.",
        file=False,
    )
    one.add_argument("--cli", type=Path, required=True, help="the program underact-cli")
    one.add_argument(
        "--window", type=Path, help="the program underact, for pictures of the 3D view"
    )
    one.add_argument("--out", type=Path, required=True, help="a folder; created if missing")
    one.add_argument("--only", help="comma-separated figures, such as 4.2,5.7")
    one.add_argument(
        "--progress-lines",
        action="store_true",
        help="report progress on standard error, one JSON object per line",
    )
    return top


def main(arguments: list[str] | None = None) -> int:
    """Runs a command; gives the exit status: 0 well, 1 bad input, 2 wrong usage, 4 a file,
    5 a library that an export takes is missing."""
    options = parser().parse_args(arguments)
    try:
        return options.run(options)
    except ModuleNotFoundError as error:
        if (error.name or "").startswith(__package__):
            raise  # one of ours: nothing to install
        print(printed(missing(error.name)), file=sys.stderr)
        return FILE
    except Unreadable as error:
        print(printed(error), file=sys.stderr)
        return FILE
    except MissingLibrary as error:
        print(printed(error), file=sys.stderr)
        return LIBRARY
    except SessionError as error:
        print(printed(error), file=sys.stderr)
        return BAD_INPUT
    except ValueError as error:
        print(printed(error), file=sys.stderr)
        return USAGE
    except OSError as error:
        sentence = f"{error.filename or ''}: {error.strerror or error}.".lstrip(": ")
        print(printed(sentence), file=sys.stderr)
        return FILE
    except MemoryError:
        print("There is not enough memory for a session of this length.", file=sys.stderr)
        return FILE
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
