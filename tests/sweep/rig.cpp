#include "tests/sweep/rig.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include "app/sweeper/command.h"
#include "core/sweep/journal.h"
#include "tests/support/pattern.h"

namespace underact::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto kPatience = 60s;

}  // namespace

Given sweepHere(std::vector<std::string> arguments) {
  std::istringstream in;
  std::ostringstream out, err;
  const cli::Streams streams{in, out, err};
  const cli::Exit exit = sweep::execute(std::move(arguments), streams, nullptr);
  return {exit, out.str(), err.str()};
}

std::string sweepProgram() {
  return std::string("'") + UNDERACT_BINARY + "/underact-sweep'";
}

std::string gatedProgram() {
  return std::string("'") + UNDERACT_GATED_SWEEP + "'";
}

Process::Process(const std::string& command, const std::string& given) {
  const std::string whole = "exec " + command + " >'" + given + "' 2>&1 </dev/null";
  pid_ = fork();
  if (pid_ != 0) return;
  setpgid(0, 0);
  execl("/bin/sh", "sh", "-c", whole.c_str(), nullptr);
  _exit(127);
}

Process::~Process() {
  if (pid_ <= 0 || status_) return;
  kill(-pid_, SIGKILL);
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

bool Process::hasEnded() {
  int status = 0;
  if (!status_ && waitpid(pid_, &status, WNOHANG) != 0) status_ = status;
  return status_.has_value();
}

int Process::wait() {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!hasEnded()) {
    if (std::chrono::steady_clock::now() > end) {
      ADD_FAILURE() << "The program does not end.";
      return -1;
    }
    std::this_thread::sleep_for(2ms);
  }
  return WIFEXITED(*status_) ? WEXITSTATUS(*status_) : -WTERMSIG(*status_);
}

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> argumentsOf(const std::string& command) {
  std::istringstream in(command);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  words.erase(words.begin());
  return words;
}

pid_t rankOf(pid_t mpirun, int rank) {
  const std::string parent = "\nPPid:\t" + std::to_string(mpirun) + "\n";
  const std::string mark = std::string(1, '\0') + "OMPI_COMM_WORLD_RANK=" + std::to_string(rank) + std::string(1, '\0');
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    pid_t pid = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), pid);
    if (error != std::errc() || end != name.data() + name.size()) continue;
    if (contentOf((entry.path() / "status").string()).find(parent) == std::string::npos) continue;
    if (contentOf((entry.path() / "environ").string()).find(mark) != std::string::npos) return pid;
  }
  return -1;
}

std::size_t cellsIn(const std::string& result) {
  const std::string text = contentOf(sweep::journalOf(result));
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return lines > 0 ? lines - 1 : 0;
}

bool waitForEnd(pid_t pid) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < end) {
    const std::string status = contentOf("/proc/" + std::to_string(pid) + "/status");
    if (status.empty() || status.find("\nState:\tZ") != std::string::npos) return true;
    std::this_thread::sleep_for(2ms);
  }
  return false;
}

bool waitForCells(const std::string& result, std::size_t cells) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (cellsIn(result) < cells) {
    if (std::chrono::steady_clock::now() > end || fs::exists(result)) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

bool isFree(const std::string& result) {
  const int fd = open(sweep::journalOf(result).c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return true;
  const bool is_free = flock(fd, LOCK_EX | LOCK_NB) == 0;
  close(fd);
  return is_free;
}

int runNow(const std::string& given) {
  const std::vector<PatternMatch> found = matchesOf(" cells, ([0-9]+) of them run now", contentOf(given));
  return found.empty() ? -1 : std::stoi(found[0].groups[1]);
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string textOf(const std::string& path) {
  EXPECT_TRUE(fs::exists(path)) << path;
  return contentOf(path);
}

std::string scene(const std::string& name) {
  return std::string(UNDERACT_SOURCE) + "/scenes/" + name;
}

Table table(const std::string& result) {
  std::istringstream text(textOf(result));
  Table rows;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream fields(line);
    std::vector<std::string>& row = rows.emplace_back();
    for (std::string one; std::getline(fields, one, ',');) row.push_back(one);
  }
  return rows;
}

const std::string& field(const Table& table, std::size_t row, const std::string& column) {
  static const std::string kNone;
  const auto found = std::find(table.at(0).begin(), table.at(0).end(), column);
  if (found == table.at(0).end()) {
    ADD_FAILURE() << "no column " << column;
    return kNone;
  }
  return table.at(row).at(static_cast<std::size_t>(found - table.at(0).begin()));
}

double number(const Table& table, std::size_t row, const std::string& column) {
  return std::stod(field(table, row, column));
}

}  // namespace underact::test
