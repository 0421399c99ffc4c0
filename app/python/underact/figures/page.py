"""The page that shows the figures: one file, relative pictures, no scripts."""

from __future__ import annotations

from html import escape

_STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #1a1a1a; background: #fff; max-width: 60rem;
  margin: 2rem auto; padding: 0 1rem }
h1 { font-size: 1.6rem } h2 { font-size: 1.15rem; margin: 3rem 0 0.5rem }
img { max-width: 100%; height: auto; border: 1px solid #ddd }
table { border-collapse: collapse; font-size: 0.9rem; margin: 0.75rem 0; width: 100% }
th, td { text-align: left; padding: 0.2rem 0.6rem; border-bottom: 1px solid #ddd;
  vertical-align: top }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap }
.fail { color: #a63f00; font-weight: 600 } .quiet { color: #555 }
nav a { margin-right: 0.6rem }
"""


def _number(value: float | None) -> str:
    return "none" if value is None else f"{value:.6g}"


def _table(numbers: list[dict]) -> str:
    rows = []
    for n in numbers:
        sign = "✓ pass" if n["passed"] else "✗ fail"
        rows.append(
            f"<tr><td>{escape(n['what'])}</td><td class=n>{_number(n['measured'])}</td>"
            f"<td class=n>{_number(n['expected'])}</td><td class=n>{_number(n['tolerance'])}</td>"
            f"<td>{escape(n['unit'])}</td><td "
            f"class={'pass' if n['passed'] else 'fail'}>{sign}</td></tr>"
        )
    head = "<tr><th>number<th class=n>measured<th class=n>expected<th class=n>tolerance<th>unit<th>"
    return f"<table>{head}</tr>{''.join(rows)}</table>" if rows else ""


def _links(row: dict) -> str:
    kinds = [("scene", row["scene"]), ("hand", row["hand"]), ("session", row["session"])]
    kinds += [(picture.rsplit(".", 1)[1].upper(), picture) for picture in row["pictures"]]
    return " · ".join(f'<a href="{escape(path)}">{name}</a>' for name, path in kinds if path)


def _section(row: dict) -> str:
    key, title = escape(row["figure"]), escape(row["title"])
    pictures = [picture for picture in row["pictures"] if picture.endswith(".png")]
    image = f'<img src="{escape(pictures[0])}" alt="Figure {key}: {title}">' if pictures else ""
    left_out = f"<p class=quiet>{escape(row['left_out'])}</p>" if row["left_out"] else ""
    problem = f"<p class=fail>{escape(row['problem'])}</p>" if row["problem"] else ""
    return (
        f'<section id="f{key}"><h2>Figure {key}: {title}</h2>{image}<p>{escape(row["caption"])}</p>'
        f"{left_out}{problem}<p class=quiet>{_links(row)}</p>{_table(row['numbers'])}</section>"
    )


def page(rows: list[dict]) -> str:
    """The page as HTML, from the rows of figures.json."""
    numbers = [number for row in rows for number in row["numbers"]]
    failed = sum(not number["passed"] for number in numbers) + sum(
        bool(row["problem"]) for row in rows
    )
    count = f"{len(rows)} figures, {len(numbers)} numbers checked, "
    verdict = "all pass." if failed == 0 else f"{failed} failed."
    links = "".join(
        f'<a href="#f{escape(row["figure"])}">{escape(row["figure"])}</a>' for row in rows
    )
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>Figures of the thesis, remade</title><style>{_STYLE}</style></head><body>"
        "<h1>Figures of the thesis, remade</h1>"
        "<p>Beckman 2007: every figure that shows data, remade by the program with the settings of "
        "the thesis, and numbers that check it. The arm and the hand are simulated; nothing here "
        "was measured on a device. "
        "Where the thesis has a misprint, the corrected equation is used.</p>"
        f"<p class={'fail' if failed else 'pass'}>{count}{verdict}</p><nav>{links}</nav>"
        + "\n".join(_section(row) for row in rows)
        + "</body></html>\n"
    )
