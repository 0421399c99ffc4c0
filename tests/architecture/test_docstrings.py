"""Each public function and type that a header of core declares has a comment: above it, behind it, or one for its group."""

import pathlib
import re
import unittest

CORE = pathlib.Path(__file__).parents[2] / "core"
TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|union|enum class|enum|using) ")
ACCESSOR = re.compile(r"\) (?:const )?(?:noexcept )?(?:UNDERACT_\w+ )?\{ return [*&]*[\w.]+(?:\(\))?; \}$")
PASSED_OVER = re.compile(r"^(?:friend|static_assert|extern|UNDERACT_|template <>|[})])|^~|\boverride\b|= (?:delete|default);|^\w+ \w+;$")


def declarations(lines):
    """(line number, code, is public, has a comment behind it, last line) of each at the layout that clang-format gives."""
    scopes, public, at = [(-2, "")], [True], 0
    while at < len(lines):
        line, first = lines[at], at
        indent, code = len(line) - len(line.lstrip()), re.sub(r"\s*//.*", "", line).strip()
        at += 1
        if len(scopes) > 1 and indent == scopes[-1][0] and line.lstrip().startswith("}"):
            scopes.pop(), public.pop()
        elif label := re.fullmatch(r"(public|private|protected):", code):
            public[-1] = label[1] == "public"
        elif indent == scopes[-1][0] + 2 and code and not re.match(r"#|//|\}|namespace|\{", code):
            behind = "  // " in line
            while not re.search(r"[;{}]$", code) and at < len(lines):
                behind = behind or "  // " in lines[at]
                code += " " + re.sub(r"\s*//.*", "", lines[at]).strip()
                at += 1
            kind = re.match(r"(?:template <.*> )?(struct|class|union) .*\{$", code)
            if kind and "(" not in re.sub(r"alignas\(\d+\)|\[\[.*?\]\]", "", code):
                yield first, code, public[-1], behind, at - 1
                scopes.append((indent, code)), public.append(public[-1] and kind[1] != "class")
                continue
            if code.endswith("{"):
                while at < len(lines) and not re.match(rf" {{{indent}}}\}}", lines[at]):
                    at += 1
                at += 1
            yield first, code, public[-1], behind, at - 1


def uncommented(text):
    """The lines, from 1, of what has no comment. Overloads share one that is above the first of them."""
    lines, last, name, grouped = text.split("\n"), -2, None, False
    for first, code, is_public, behind, end in declarations(lines):
        above = lines[first - 1].strip() if first else ""
        called = re.search(r"(operator\S+|\w+)\(", code)
        same = first == last + 1 and called and called[1] == name
        has = behind or above.startswith("//") or same or (first == last + 1 and grouped)
        if above.startswith("//"):
            grouped = not above.startswith("///")
        elif first != last + 1:
            grouped = False
        last, name = end, called[1] if has and called else None
        is_function = called and not TYPE.match(code) and "=" not in code[: called.start()]
        wanted = is_public and (is_function or TYPE.match(code) and not re.fullmatch(r"(?:struct|class) \w+;", code))
        if wanted and not has and not PASSED_OVER.search(code) and not ACCESSOR.search(code):
            yield first + 1


class Docstrings(unittest.TestCase):
    def test_no_public_function_of_core_is_without_one(self):
        found = [
            f"{path.relative_to(CORE.parent)}:{line}"
            for path in sorted(CORE.rglob("*.h"))
            for line in uncommented(path.read_text(encoding="utf-8"))
        ]
        self.assertEqual(found, [], "\n".join(found))

    def test_one_that_is_missing_is_found(self):
        missing = ["int f();", "struct S {", " public:", "  void g(int x);", " private:", "  void h();", "};"]
        self.assertEqual(list(uncommented("\n".join(missing))), [1, 2, 4])
        self.assertEqual(list(uncommented("/// Says it.\nint f();\nint f(int x);\n\n// Both.\nint a();\nint b();")), [])


if __name__ == "__main__":
    unittest.main()
