#include "core/base/printed.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "app/cli/lines.h"
#include "app/cli/printed_stream.h"
#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

/// Words that set a terminal's title, clear it, turn the text round and begin a line that looks like the program's.
const std::string kHostile = "\x1B]0;x\x07\x1B[2J\u009B\u202E\r\nFORGED  yes";

/// What a terminal gets: nothing that operates it, and no line that is none of the program's. It names the words.
void expectClean(const std::vector<std::string>& arguments) {
  const Outcome outcome = runCli(arguments);
  const std::string all = outcome.out + outcome.err;
  for (std::size_t at = 0; at < all.size(); ++at)
    if (all[at] != '\n' && all[at] != '\t')
      ASSERT_EQ(controlLength(all, at), 0u) << arguments[0] << ": " << printed(all);
  EXPECT_EQ(all.find("\nFORGED"), std::string::npos) << arguments[0] << ":\n" << all;
  EXPECT_NE(all.find("FORGED"), std::string::npos) << arguments[0] << " does not say it:\n" << all;
}

}  // namespace

TEST(PrintedWords, OfSessionsCannotOperateATerminal) {
  const ScratchPath one("one.h5");
  ASSERT_EQ(runCli({"run", shipped("02_sphere.json"), "--hand", "probe", "--seconds", "0.1", "--fast", "--record",
                    one.path(), "--name", kHostile, "--notes", kHostile, "--tags", kHostile, "--subject", kHostile,
                    "--consent", kHostile})
                .exit,
            Exit::Success);
  expectClean({"log", "info", one.path()});
  expectClean({"log", "info", one.path(), "--json"});
  const std::string renamed = one.path() + kHostile + ".h5";
  std::filesystem::rename(one.path(), renamed);
  expectClean({"log", "remove", "--participant", kHostile, renamed});
  std::filesystem::resize_file(renamed, std::filesystem::file_size(renamed) / 2);
  expectClean({"log", "verify", renamed});
  std::filesystem::remove(renamed);
}

TEST(PrintedWords, OfScenesLessonsAndMeshesCannotOperateATerminal) {
  const std::string quoted = json::quotedText(kHostile);
  const ScratchFile scene(R"({"underact_scene": 1, "title": )" + quoted + R"(, "constraints": [{"type": "sphere",
      "center_mm": [0, 0, 0], "radius_mm": 50, "name": )" +
                          quoted + R"(}, {"type": "point", "position_mm": [0, 0, 0]}]})");
  const ScratchFile wrong(sceneText(R"({"type": "sphere", )" + quoted + R"(: 1, "radius_mm": )" + quoted + "}"));
  const ScratchFile lesson(R"({"underact_lesson": 1, "title": "T", )" + quoted + R"(: 1, "steps": [{"title": "A",
      "text": "B", "scene": )" +
                           quoted + R"(, "checks": [{"measure": )" + quoted + R"(, "above": 1}]}]})");
  const std::vector<std::vector<std::string>> commands{
      {"scene", "show", scene.path()},
      {"lab", "step", "--scene", scene.path(), "--constraint", "sphere" + kHostile},
      {"scene", "check", wrong.path()},
      {"scene", "check", wrong.path() + kHostile},
      {"target", wrong.path()},
      {"lesson", "check", lesson.path()},
      {"mesh", "info", "/nowhere" + kHostile + ".stl"},
      {"fk", "--arm", kHostile},
      {"arm", "convert", kHostile, "--to", "dh"},
      {"run", shipped("02_sphere.json"), "--seconds", "0.1", "--device", kHostile}};
  for (const std::vector<std::string>& command : commands) expectClean(command);
}

TEST(PrintedStream, ShowsControlCharactersAndKeepsTheProgramsOwnLines) {
  std::ostringstream to;
  cli::PrintedStream out(to);
  out << "a\tb\x1B[2J\u202Eü\n" << 1.5 << '\r' << "\r" << std::flush;
  EXPECT_EQ(to.str(), "a\tb\\u001b[2J\\u202eü\n1.5\r\r");
  out << "back\rwards" << char(7);
  EXPECT_EQ(to.str().substr(to.str().find("back")), "back\\rwards\\u0007") << to.str();
  to.setstate(std::ios::badbit);
  out << "more" << std::flush;
  EXPECT_FALSE(out) << "a full disk is noticed";
}

TEST(PrintedStream, ALineForPeopleIsOneLine) {
  std::ostringstream to;
  { cli::Lines(to, -1)("An arm\x1B\nFORGED is shared."); }
  EXPECT_EQ(to.str(), "An arm\\u001b\\nFORGED is shared.\n");
}

}  // namespace underact::test
