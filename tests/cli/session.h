#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/base/types.h"
#include "core/json/json.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {

/// What a command gave.
struct Outcome {
  cli::Exit exit = cli::Exit::Success;
  std::string out;
  std::string err;
};

/// The program in this process, with text for its standard input.
Outcome runCli(std::vector<std::string> arguments, const std::string& in = "");

/// The program as a process, through the shell: "... target X < Y". exit: as the shell says.
struct ProcessOutcome {
  int exit = -1;
  std::string out;  // and what was sent there by 2>&1
};
ProcessOutcome shell(const std::string& command);

/// The path of underact-cli, in quotes.
std::string program();

/// The lines of out, each read as JSON; a line that is not JSON fails the test.
std::vector<json::Value> lines(const std::string& out);

/// A member's text, number, or list of numbers; fails the test where it is not there.
std::string textAt(const json::Value& object, const std::string& key);
double numberAt(const json::Value& object, const std::string& key);
Vec3 vectorAt(const json::Value& object, const std::string& key);
bool isNullAt(const json::Value& object, const std::string& key);

/// A file that is gone with the object.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& text, const std::string& name = "scene.json");
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// The path of a file that is not there yet; what comes to be there is gone with the object.
class ScratchPath {
 public:
  explicit ScratchPath(const std::string& name) : path_(folder_.file(name)) {}
  std::string path() const { return path_; }

 private:
  ScratchFolder folder_;
  std::string path_;
};

/// What is in a file; empty where it is not there.
std::string fileContent(const std::string& path);

/// A scene of the constraints given as JSON; more: further members, each ending in a comma.
std::string sceneText(const std::string& constraints, const std::string& more = "");

/// The scene file of that name that ships.
std::string shipped(const std::string& name);

}  // namespace underact::test
