"""The files of the package import one another in one direction.

Imports for types and those within a call count, too.
"""

import ast
import graphlib
import unittest

from support import ROOT

PACKAGE = ROOT / "app/python/underact"


class Imports(unittest.TestCase):
    def test_no_files_import_each_other_in_a_circle(self):
        imports = {}
        for path in PACKAGE.rglob("*.py"):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.ImportFrom) and node.level:
                    names = [node.module] if node.module else [alias.name for alias in node.names]
                    parts = [
                        path.parents[node.level - 1] / name.replace(".", "/") for name in names
                    ]
                    imports.setdefault(path.with_suffix(""), []).extend(parts)
        self.assertIn(PACKAGE / "canvas", imports[PACKAGE / "pictures"])
        graphlib.TopologicalSorter(imports).prepare()  # raises CycleError with the circle
