"""Writes the ticks of a session in other forms: CSV, Parquet, MCAP."""

from __future__ import annotations

import csv as csv_module
import json
import math
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from . import layout
from .errors import MissingLibrary
from .output import check_name, new_file
from .session import Session, tick_columns

#: what to ask pip for: a newer pyarrow wants a newer numpy than Debian 12 has
_PACKAGES = {"pyarrow": "'pyarrow<17'", "mcap": "mcap"}


def _needs(package: str, form: str, error: ImportError) -> MissingLibrary:
    here = (
        "is not installed"
        if isinstance(error, ModuleNotFoundError)
        else f"does not work here ({error})"
    )
    return MissingLibrary(
        f"Writing {form} takes the Python package {package}, which {here}. "
        f"Install it with: python3 -m pip install {_PACKAGES[package]} (on Debian in an "
        "environment made with "
        "python3 -m venv --system-site-packages DIR). Or export CSV, which takes nothing."
    )


def _flat(session: Session) -> dict[str, np.ndarray]:
    """The columns of a CSV recording, with time in s and faults as words."""
    flat, columns = {}, tick_columns(session)
    for field in layout.CSV:
        if field["column"] in columns:
            values = columns[field["column"]]
            flat[field["name"]] = values if values.ndim == 1 else values[:, field["part"]]
    flat["time_s"] = session.time_s
    flat["fault"] = np.array(
        [layout.word(layout.FAULTS, int(kind)) for kind in flat["fault"]], dtype=object
    )
    return flat


def _word(value: object) -> str:
    """A field of CSV: the shortest number that reads back the same; empty where it is none."""
    if isinstance(value, float):
        if not math.isfinite(value):
            return ""
        return (
            repr(int(value))
            if value.is_integer() and abs(value) < 1e15 and str(value) != "-0.0"
            else repr(value)
        )
    return str(value)


def form_of(out: str | Path, wanted: str | None) -> str:
    """The form that is asked for, or that the name ends in; CSV where neither says one. Raises
    ValueError where they differ.
    """
    ending = Path(out).suffix.lower().lstrip(".")
    by_name = ending if ending in (*FORMATS, "rrd", "html") else None
    form = wanted or by_name or "csv"
    if form not in FORMATS or by_name not in (None, form):
        raise ValueError(f"{out}: the name ends as that of another format; nothing was written.")
    return form


def csv_metadata(session: Session, name: str) -> dict:
    """What a CSV file of that name holds, as the W3C's CSV on the Web has it (tabular metadata):
    each column with type, unit and meaning; in its notes the frames, and what was run.
    """
    columns, frames = [], {}
    has_more = session.more_joints() is not None
    for field in layout.CSV:
        if field["column"] == layout.MORE and not has_more:
            continue
        described = layout.TICK[field["column"]]
        kind = {"float64": "double", "string": "string"}.get(field["type"], "integer")
        one = {"name": field["name"], "titles": field["name"], "datatype": kind, "null": ""}
        one["dc:description"] = described["meaning"]
        one["schema:unitText"] = field["unit"]
        columns.append(one)
        frames[field["name"]] = described["frame"]
    return {
        "@context": "http://www.w3.org/ns/csvw",
        "url": name,
        "tableSchema": {"columns": columns},
        "notes": [{"frames": frames, **described_run(session)}],
    }


def described_run(session: Session) -> dict:
    """What goes into every export beside the numbers: attributes, scene, provenance, clock."""
    changes = session.changes
    return {
        **session.attributes,
        "scene": changes[0].scene if changes else {},
        "provenance": session.provenance,
        "provenance_changes": [
            {"tick": tick, "changed": changed} for tick, changed in session.provenance_changes
        ],
        "clock": {name: values.tolist() for name, values in session.clock.items()},
    }


def _run_words(session: Session) -> dict[str, str]:
    """The same as texts."""
    return {
        name: json.dumps(value) if isinstance(value, (dict, list)) else str(value)
        for name, value in described_run(session).items()
    }


def csv(session: Session, out: str | Path) -> None:
    """The same columns as `underact-cli run --record F.csv`, read back to the same numbers; beside
    it F.csv-metadata.json, which says what they are and what was run.
    """
    beside = Path(f"{out}-metadata.json")
    for path in (out, beside):
        check_name(path, session.path)
    columns = _flat(session)
    with new_file(out, "w", encoding="utf-8", newline="") as file:
        writer = csv_module.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(
            [_word(value) for value in row] for row in zip(*(c.tolist() for c in columns.values()))
        )
    with new_file(beside, "w", encoding="utf-8") as file:
        json.dump(csv_metadata(session, Path(out).name), file, ensure_ascii=False)


def parquet(session: Session, out: str | Path) -> None:
    """All columns of /ticks, vectors split as in Session.frame(), each with unit, frame and meaning
    as metadata of its field; the session's attributes, scene and provenance as metadata of the
    file. Needs pyarrow.
    """
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError as error:
        raise _needs("pyarrow", "Parquet", error) from error
    table = pyarrow.Table.from_pandas(session.frame(), preserve_index=False)
    about = {"time_s": {"unit": "s", "frame": "", "meaning": "the arm's clock at each tick"}}
    about |= {part: column for column in layout.TICK.values() for part in column["parts"]}
    fields = [
        field.with_metadata(
            {key: about.get(field.name, {}).get(key, "") for key in ("unit", "frame", "meaning")}
        )
        for field in table.schema
    ]
    words = {
        name if name.startswith("underact_") else f"underact_{name}": value
        for name, value in _run_words(session).items()
    }
    schema = pyarrow.schema(fields, metadata={**(table.schema.metadata or {}), **words})
    check_name(out, session.path)
    with new_file(out, "wb") as file:
        pyarrow.parquet.write_table(table.cast(schema), file)


_NUMBER, _TEXT = {"type": "number"}, {"type": "string"}
_SCHEMAS = {
    "/markers": {"tick": {"type": "integer"}, "time_s": _NUMBER, "label": _TEXT},
    "/faults": {
        "tick": {"type": "integer"},
        "time_s": _NUMBER,
        "kind": _TEXT,
        "seen": _NUMBER,
        "allowed": _NUMBER,
    },
}


def _tick_schema(session: Session) -> dict:
    properties: dict[str, dict] = {"time_s": _NUMBER}
    units, meanings = session.ticks.units, session.ticks.meanings
    for name in tick_columns(session):
        column = layout.TICK.get(name) or {"unit": units[name], "meaning": meanings[name]}
        one = {"type": ["number", "null"], "description": units.get(name, column["unit"])}
        one |= {key: column.get(key, "") for key in ("unit", "frame", "meaning")}
        width = column.get("width", 1)
        array = {"type": "array", "items": one, "minItems": width, "maxItems": width}
        properties[name] = one if width == 1 else array
    return properties


def _messages(session: Session) -> Iterator[tuple[int, str, dict]]:
    """(time since the first tick in ns, topic, message) of everything in a session, in the order of
    time.
    """
    ticks = session.ticks
    time_ns = ticks["time_ns"]
    tick = ticks["tick"]
    if len(tick) == 0:
        return

    def at(number: int) -> int:
        return int(time_ns[min(int(np.searchsorted(tick, number)), len(tick) - 1)])

    events = [(at(m.tick), "/markers", {"tick": m.tick, "label": m.label}) for m in session.markers]
    events += [
        (
            at(f.tick),
            "/faults",
            {"tick": f.tick, "kind": f.kind, "seen": f.seen, "allowed": f.allowed},
        )
        for f in session.faults
    ]
    events.sort(key=lambda event: event[0])
    columns = {name: values.tolist() for name, values in tick_columns(session).items()}
    for row, now_ns in enumerate(time_ns.tolist()):
        yield now_ns, "/tick", {name: _plain(values[row]) for name, values in columns.items()}
        while events and events[0][0] <= now_ns:
            yield events.pop(0)


def _plain(value: object) -> object:
    """A value as JSON has it: what is no number is null."""
    if isinstance(value, list):
        return [_plain(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def mcap(session: Session, out: str | Path) -> None:
    """JSON messages with schemas on /tick, /markers and /faults, stamped with the clock; joints 7
    and 8 as q_more_rad in /tick, of an arm that has them. Needs the package mcap.
    """
    try:
        from mcap.writer import Writer
    except ImportError as error:
        raise _needs("mcap", "MCAP", error) from error
    attributes = session.attributes
    start_ns = attributes.get("started_unix_ns")
    start_ns = start_ns if isinstance(start_ns, int) else 0
    check_name(out, session.path)
    with new_file(out, "wb") as file:
        writer = Writer(file)
        writer.start(profile="", library="underact")
        channels = {}
        for topic, properties in {"/tick": _tick_schema(session), **_SCHEMAS}.items():
            schema = {"title": topic.strip("/"), "type": "object", "properties": properties}
            schema_id = writer.register_schema(
                topic.strip("/"), "jsonschema", json.dumps(schema).encode()
            )
            channels[topic] = writer.register_channel(topic, "json", schema_id)
        first_ns = None
        for count, (now_ns, topic, message) in enumerate(_messages(session)):
            first_ns = now_ns if first_ns is None else first_ns
            data = json.dumps({"time_s": now_ns * 1e-9, **message}).encode()
            stamp = min(max(start_ns + now_ns - first_ns, 0), 2**64 - 1)  # all that MCAP has
            writer.add_message(channels[topic], stamp, data, stamp, count)
        writer.add_metadata("underact_session", _run_words(session))
        writer.finish()


FORMATS: dict[str, Callable[[Session, str | Path], None]] = {
    "csv": csv,
    "parquet": parquet,
    "mcap": mcap,
}
