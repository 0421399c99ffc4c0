"""Man pages and completion as their readers have them: man, bash, zsh and fish."""
import pathlib
import shlex
import shutil
import subprocess
import sys
import unittest

BUILD = pathlib.Path(sys.argv.pop())
SOURCE = pathlib.Path(sys.argv.pop())
DESCRIBED = BUILD / "described"
PROGRAMS = ["underact", "underact-cli", "underact-sweep"]


def run(*words, **more):
    """What a program says, on both its outputs; it must end well."""
    done = subprocess.run(words, capture_output=True, text=True, timeout=120, **more)
    assert done.returncode == 0, f"{words}: {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout, done.stderr


def complete(program, *words):
    """What bash offers for the last of the words."""
    array = " ".join(f"'{word}'" for word in (program, *words))
    name = "_" + program.replace("-", "_")
    script = (f"source {shlex.quote(str(DESCRIBED / 'bash' / program))}; COMP_WORDS=({array}); "
              f"COMP_CWORD={len(words)}; {name}; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    return set(run("bash", "-u", "-c", script)[0].split())


class Described(unittest.TestCase):
    """Each is made from the program's own grammar, so what --help says is in it."""

    def test_man_reads_the_pages_without_a_warning(self):
        if not shutil.which("man"):
            self.skipTest("man is not installed")
        for program in PROGRAMS:
            page = DESCRIBED / "man" / f"{program}.1"
            text, warnings = run("man", "--warnings", "--encoding=UTF-8", "--local-file", page,
                                 env={"LC_ALL": "C.UTF-8", "MANROFFSEQ": "", "MANWIDTH": "100",
                                      "PATH": "/usr/bin:/bin"})
            self.assertEqual(warnings, "", program)
            self.assertIn("EXIT STATUS", text)
            self.assertIn("--version", text)

    def test_the_page_names_every_command_and_option_of_help(self):
        page = (DESCRIBED / "man" / "underact-cli.1").read_text(encoding="utf-8")
        words = page.replace("\\-", "-")
        helps = run(BUILD / "underact-cli", "--help")[0]
        commands = [line.split()[0] for line in helps.split("Subcommands:")[1].splitlines()
                    if line.startswith("  ") and not line.startswith("   ")]
        self.assertGreater(len(commands), 10)
        for command in commands:
            self.assertIn(f".SS {command}\n", words)
            said = run(BUILD / "underact-cli", command, "--help")[0]
            for option in {word.rstrip(",") for word in said.split() if word.startswith("--")}:
                self.assertIn(option.split(",")[0].split("=")[0], words, command)

    def test_bash_offers_commands_options_and_choices(self):
        self.assertLessEqual({"run", "log", "replay", "mesh"}, complete("underact-cli", ""))
        self.assertEqual(complete("underact-cli", "repl"), {"replay"})
        self.assertLessEqual({"--hand", "--record"}, complete("underact-cli", "run", "--"))
        self.assertEqual(complete("underact-cli", "run", "--scheduling", "f"), {"fifo"})
        self.assertEqual(complete("underact-cli", "replay", "--law", ""), {"P", "PD", "PID"})
        self.assertLessEqual({"export", "verify"}, complete("underact-cli", "log", ""))
        self.assertEqual(complete("underact-cli", "run", "--fast", "--record", ""), set())  # files
        self.assertIn("--picture", complete("underact", "--"))
        self.assertEqual(complete("underact", "--scheduling", "r"), {"rtkit"})
        self.assertIn("--threads", complete("underact-sweep", "from", "--th"))

    def test_zsh_and_fish_understand_theirs(self):
        shells = [("zsh", "_{}", ["-n"]), ("fish", "{}.fish", ["--no-execute"])]
        there = [row for row in shells if shutil.which(row[0])]
        for shell, name, options in there:
            for program in PROGRAMS:
                run(shell, *options, DESCRIBED / shell / name.format(program))
        if len(there) < len(shells):
            self.skipTest("zsh or fish is not installed")

    def test_fish_offers_commands_and_choices(self):
        if not shutil.which("fish"):
            self.skipTest("fish is not installed")
        for typed, offered in [("underact-cli repl", "replay"),
                               ("underact-cli run --scheduling f", "fifo"),
                               ("underact-cli log ver", "verify")]:
            script = f"source {shlex.quote(str(DESCRIBED / 'fish' / 'underact-cli.fish'))}; complete -C '{typed}'"
            lines = run("fish", "--no-config", "-c", script)[0].split("\n")
            self.assertIn(offered, [line.split("\t")[0] for line in lines], typed)


if __name__ == "__main__":
    unittest.main(verbosity=2)
