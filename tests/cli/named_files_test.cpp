// Whatever lies at a name that a command is given, the answer comes at once, with the name and with status 4.
#include <gtest/gtest.h>

#include "tests/cli/session.h"
#include "tests/support/odd_files.h"
#include "tests/support/watchdog.h"

namespace underact::test {
namespace {

using cli::Exit;

TEST(NamedFileOfACommand, IsAnsweredAtOnceWhateverItIs) {
  const Watchdog watchdog(240);
  const std::string sphere = shipped("02_sphere.json");
  const std::vector<std::vector<std::string>> commands{
      {"scene", "check", "FILE"},
      {"scene", "show", "FILE"},
      {"target", "FILE"},
      {"run", "FILE", "--hand", "still", "--seconds", "0.1", "--fast"},
      {"run", sphere, "--hand", "FILE", "--seconds", "0.1", "--fast"},
      {"run", sphere, "--hand", "still", "--arm-model", "FILE", "--seconds", "0.1", "--fast"},
      {"fk", "--arm", "FILE"},
      {"arm", "convert", "FILE", "--to", "poe"},
      {"lesson", "check", "FILE"},
      {"mesh", "info", "FILE"},
      {"register", "--points", "FILE"},
      {"register", "--marks", "FILE", "--points", "FILE"},
      {"calibrate", "FILE"},
      {"lab", "step", "--scene", "FILE"},
      {"log", "info", "FILE"},
      {"log", "verify", "FILE"},
      {"log", "export", "FILE"},
      {"log", "recover", "FILE"},
      {"replay", "FILE"},
      {"replay", UNDERACT_TEST_DATA "/golden/session.h5", "--scene", "FILE"}};
  const ScratchFolder folder;
  const std::vector<OddFile> files = oddFiles(folder, ".json");
  for (const std::vector<std::string>& command : commands) {
    for (const OddFile& odd : files) {
      std::vector<std::string> words = command;
      for (std::string& word : words) word = word == "FILE" ? odd.path : word;
      const Outcome outcome = runCli(words);
      const std::string told = command[0] + " " + command[1] + ", " + odd.what + ": " + outcome.err;
      EXPECT_NE(outcome.exit, Exit::Success) << told;
      EXPECT_NE(outcome.err.find(odd.path), std::string::npos) << told;
    }
  }
}

// A file may come through the standard input as a file; as a pipe it has no end that is known.
TEST(NamedFileOfACommand, ThroughTheStandardInputIsReadFromAFileAndNotFromAPipe) {
  const Watchdog watchdog;
  const std::string check = program() + " scene check /dev/stdin", scene = "'" + shipped("02_sphere.json") + "'";
  EXPECT_EQ(shell(check + " < " + scene).exit, 0);
  const ProcessOutcome piped = shell("cat " + scene + " | " + check + " 2>&1");
  EXPECT_EQ(piped.exit, 4);
  EXPECT_NE(piped.out.find("/dev/stdin: error: This is a pipe"), std::string::npos) << piped.out;
}

}  // namespace
}  // namespace underact::test
