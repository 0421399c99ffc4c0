#include "tests/cli/session.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

namespace underact::test {
namespace {

const json::Value& memberAt(const json::Value& object, const std::string& key) {
  static const json::Value kNothing;
  const json::Value* member = object.find(key);
  if (member == nullptr) ADD_FAILURE() << "no key " << key;
  return member != nullptr ? *member : kNothing;
}

}  // namespace

Outcome runCli(std::vector<std::string> arguments, const std::string& in) {
  std::istringstream input(in);
  std::ostringstream out, err;
  const cli::Streams streams{input, out, err};
  const cli::Exit exit = cli::execute(std::move(arguments), streams);
  return {exit, out.str(), err.str()};
}

ProcessOutcome shell(const std::string& command) {
  ProcessOutcome outcome;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> part{};
  for (std::size_t count = 0; (count = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
    outcome.out.append(part.data(), count);
  }
  const int status = pclose(pipe);
  outcome.exit = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

std::string program() {
  return std::string("'") + UNDERACT_BINARY + "/underact-cli'";
}

std::vector<json::Value> lines(const std::string& out) {
  std::vector<json::Value> values;
  std::istringstream stream(out);
  for (std::string line; std::getline(stream, line);) {
    Result<json::Value> value = json::parse(line, "out");
    if (value) {
      values.push_back(std::move(value).value());
    } else {
      ADD_FAILURE() << "not JSON: " << line;
    }
  }
  return values;
}

std::string textAt(const json::Value& object, const std::string& key) {
  return memberAt(object, key).text;
}

double numberAt(const json::Value& object, const std::string& key) {
  const json::Value& member = memberAt(object, key);
  EXPECT_EQ(member.kind, json::JsonKind::Number) << key;
  return member.number;
}

Vec3 vectorAt(const json::Value& object, const std::string& key) {
  const json::Value& member = memberAt(object, key);
  if (member.items.size() != 3) {
    ADD_FAILURE() << key << " is no list of three";
    return Vec3::Constant(kNotANumber);
  }
  return {member.items[0].number, member.items[1].number, member.items[2].number};
}

bool isNullAt(const json::Value& object, const std::string& key) {
  return memberAt(object, key).kind == json::JsonKind::Null;
}

ScratchFile::ScratchFile(const std::string& text, const std::string& name) {
  static int number = 0;
  path_ = std::filesystem::temp_directory_path() /
          ("underact_cli_" + std::to_string(getpid()) + "_" + std::to_string(++number) + "_" + name);
  std::ofstream(path_) << text;
}

ScratchFile::~ScratchFile() {
  std::filesystem::remove(path_);
}

std::string fileContent(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string sceneText(const std::string& constraints, const std::string& more) {
  return R"({"underact_scene": 1, "title": "Test", )" + more + R"("constraints": [)" + constraints + "]}";
}

std::string shipped(const std::string& name) {
  return std::string(UNDERACT_SOURCE) + "/scenes/" + name;
}

}  // namespace underact::test
