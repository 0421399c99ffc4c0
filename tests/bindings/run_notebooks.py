"""Runs the guide's notebooks, and compares what they print with what they show: `run_notebooks.py [--keep] [NOTEBOOK]...`.

--keep writes the outputs back instead. live_service.ipynb takes a running program, which tests/python/test_clients.py has.
Exit status 0; 1 where a cell fails or prints something else; 77 where nbclient is not installed.
"""

from __future__ import annotations

import base64
import io
import os
import re
import sys
import tempfile
from pathlib import Path
from typing import Any

GUIDE = Path(__file__).resolve().parents[2] / "resources/guide"
NOTEBOOKS = sorted(path for path in GUIDE.glob("*.ipynb") if path.stem != "live_service")


def shown(cell: Any) -> str:
    """The text that a cell shows, without pictures, addresses of objects and what pandas makes of a table for a browser."""
    texts = []
    for output in cell.get("outputs", []):
        texts.append(output.get("text", "") or output.get("data", {}).get("text/plain", ""))
    return re.sub(r"<(Figure|Axes).*?>|0x[0-9a-f]+", "", "".join(texts)).strip()


def smaller(png: str) -> str:
    """The picture with 48 colours, in a quarter of the bytes."""
    from PIL import Image

    small = io.BytesIO()
    picture = Image.open(io.BytesIO(base64.b64decode(png))).convert("RGB").quantize(48, method=Image.Quantize.FASTOCTREE)
    picture.save(small, "png", optimize=True)
    return base64.b64encode(small.getvalue()).decode()


def run(path: Path, keep: bool = False) -> list[str]:
    """Runs a notebook; what is wrong with it. Raises ImportError without nbclient."""
    import nbformat
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError

    notebook = nbformat.read(path, as_version=4)
    before = [shown(cell) for cell in notebook.cells]
    with tempfile.TemporaryDirectory() as folder:
        os.environ |= {"IPYTHONDIR": folder, "MPLCONFIGDIR": folder, "PYDEVD_DISABLE_FILE_VALIDATION": "1"}
        client = NotebookClient(notebook, timeout=600, kernel_name="python3", resources={"metadata": {"path": folder}})
        try:
            client.execute()
        except CellExecutionError as error:
            return [f"{path.name}: {error}"]
    if keep:
        for cell in notebook.cells:
            cell.metadata.clear()  # times of a run
            for output in cell.get("outputs", []):
                output.get("data", {}).pop("text/html", None)  # of a table, which the text shows
                output.get("metadata", {}).clear()
                if "image/png" in output.get("data", {}):
                    output.data["image/png"] = smaller(output.data["image/png"])
        notebook.metadata.pop("language_info", None)
        nbformat.write(notebook, path)
        return []
    after = [shown(cell) for cell in notebook.cells]
    return [
        f"{path.name}, cell {number} prints\n{is_}\nbut shows\n{was}"
        for number, (was, is_) in enumerate(zip(before, after), start=1)
        if was != is_
    ]


def main(words: list[str]) -> int:
    """Runs those that are named, or all."""
    wrong = []
    try:
        for path in [Path(word) for word in words if word != "--keep"] or NOTEBOOKS:
            wrong += run(path, "--keep" in words)
            print(f"{path.name}: run, {path.stat().st_size / 1e3:.0f} kB")
    except ImportError as error:
        print(f"SKIPPED: {error}; `pip install nbclient ipykernel` brings it. The notebooks were not run.")
        return 77
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
