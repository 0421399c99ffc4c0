"""hidden_names finds each thing by which a file of a folder meddles with those beside it."""

import contextlib
import importlib.machinery
import importlib.util
import io
import pathlib
import tempfile
import unittest

HERE = pathlib.Path(__file__).parent
LOADER = importlib.machinery.SourceFileLoader("hidden_names", str(HERE / "hidden_names"))
hidden_names = importlib.util.module_from_spec(
    importlib.util.spec_from_loader("hidden_names", LOADER)
)
LOADER.exec_module(hidden_names)


def hiding(text, space="underact::new"):
    """A source that has this in its unnamed namespace."""
    begin, end = f"namespace {space} {{\n", f"}}  // namespace {space}\n"
    return f"{begin}namespace {{\n{text}\n}}  // namespace\n{end}"


class HiddenNames(unittest.TestCase):
    def said(self, files):
        with tempfile.TemporaryDirectory() as folder:
            for path, text in files.items():
                (pathlib.Path(folder) / path).parent.mkdir(parents=True, exist_ok=True)
                (pathlib.Path(folder) / path).write_text(text, encoding="utf-8")
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                status = hidden_names.main(pathlib.Path(folder))
        self.assertEqual(status, 0 if said.getvalue().startswith("The files of each") else 1)
        return [] if status == 0 else said.getvalue().splitlines()

    def beside(self, a, b):
        return self.said({"core/new/a.cpp": a, "core/new/b.cpp": b})

    def test_a_name_in_two_files_of_a_folder_is_said_with_both(self):
        self.assertEqual(
            self.beside(hiding("int twice(int x) {\n  return 2 * x;\n}"), hiding("int twice();")),
            [
                "core/new/b.cpp:3: twice stands in a.cpp, too, which is compiled with it: "
                "give one of them another name."
            ],
        )

    def test_so_is_one_of_another_kind_or_with_other_arguments(self):
        for one in (
            "void same(int x) {",
            "template <class T>\nsame same(T x) {",
            "struct same {",
            "class same final : public Port {",
            "enum class same { None };",
            "using same = int;",
            "int same = 0;",
            "std::atomic<int> same{0};",
            "constexpr double same[] = {1.0};",
            "const Shape same(1.0);",
        ):
            self.assertEqual(len(self.beside(hiding("int same(double x);"), hiding(one))), 1, one)

    def test_so_is_each_constant_of_a_list(self):
        first = hiding("constexpr int kOne = 1;")
        for more in (
            "constexpr int kTwo = 2, kOne = 1;",
            "constexpr int kTwo = f(1, 2),\n              kOne = 1;",
        ):
            self.assertEqual(len(self.beside(first, hiding(more))), 1, more)

    def test_so_are_types_and_constants_outside_of_an_unnamed_namespace(self):
        for one in ("struct Same {\n};", "using Same = int;", "constexpr int Same = 1;"):
            text = f"namespace underact::new {{\n{one}\n}}  // namespace underact::new\n"
            self.assertEqual(len(self.beside(text, hiding("class Same {\n};"))), 1, one)

    def test_so_is_each_name_of_an_enumeration_that_has_no_scope(self):
        for one in (
            "enum Row { kOne, kSame };",
            "enum { kSame = 3 };",
            "enum Row : std::uint8_t {\n  kOne = 1,\n  kSame,\n};",
        ):
            said = self.beside(hiding("constexpr int kSame = 1;"), hiding(one))
            self.assertEqual(len(said), 1, one)
            self.assertIn("kSame stands in a.cpp", said[0])
        self.assertEqual(self.beside(hiding("int kSame = 1;"), hiding("enum class A { kSame };")), [])

    def test_features_of_the_window_count_as_one_folder(self):
        files = {"app/gui/a/one.cpp": hiding("int i;"), "app/gui/b/two.cpp": hiding("int i;")}
        self.assertEqual(self.said(files), [])
        features = {f"app/gui/{folder}/feature.cpp": "" for folder in "ab"}
        self.assertEqual(len(self.said(files | features)), 1)

    def test_what_is_no_name_of_the_files_own_is_none(self):
        for one in (
            "class Other;\nusing base::Same;",
            "// void same() {",
            'const char* kText = R"(\nvoid same() {\n)";',
            "void other() {\n  int same = 0;\n}",
            "void Other::same() {\n}",
            "TEST(Other, same) {",
        ):
            self.assertEqual(self.beside(hiding("void same();"), hiding(one)), [], one)
        self.assertEqual(self.beside(hiding("void same();"), hiding("void same();", "other")), [])
        other = {"core/new/a.cpp": hiding("int i;"), "core/old/a.cpp": hiding("int i;")}
        self.assertEqual(self.said(other), [])

    def test_a_function_that_hides_one_of_a_header_further_out_is_said(self):
        files = {
            "core/base/a.h": "namespace underact {\ndouble half(double x);\n}  // namespace\n",
            "core/new/a.cpp": hiding("double half(int x) {"),
        }
        self.assertEqual(
            self.said(files),
            ["core/new/a.cpp:3: half() hides that of core/base/a.h in the files beside it."],
        )

    def test_what_goes_on_in_the_files_after_it_is_said(self):
        for one in ("static int two() {", "using namespace other;", "#define OTHER 1"):
            said = self.beside(one + "\n", "")
            self.assertEqual(len(said), 1, one)
            self.assertTrue(said[0].startswith("core/new/a.cpp:1: "), one)
        self.assertEqual(self.said({"core/new/alone.cpp": "using namespace other;\n"}), [])
        for one in (
            "#define OTHER 1\n#include <other.h>\n#undef OTHER",
            "using namespace std::chrono_literals;",
            "void f() {\n  using namespace other;\n}",
        ):
            self.assertEqual(self.beside(one + "\n", ""), [], one)


if __name__ == "__main__":
    unittest.main()
