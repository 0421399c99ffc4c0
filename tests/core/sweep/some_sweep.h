#pragma once
#include <sys/resource.h>

#include <filesystem>
#include <string>

#include "core/sweep/sweep.h"

namespace underact::test {

/// A folder that is gone with the object.
class SweepFolder {
 public:
  SweepFolder();
  ~SweepFolder();
  SweepFolder(const SweepFolder&) = delete;
  SweepFolder& operator=(const SweepFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// While one lives, no file of this process grows beyond a size: writes fail as on a full disk.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes);
  ~SmallFiles();
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  void (*before_signal_)(int) = nullptr;
};

/// A small kind: `cells` of them, each with its number's half, its seed and a word. The cell `bad` says a problem, the
/// cell `thrown` throws, the cell `short` has a field too few. `wait_us`: how long each takes.
sweep::SweepKind someKind();
sweep::Sweep someSweep(const sweep::Options::Values& given = {}, std::uint64_t seed = 1);

/// The rows of all cells, made one after the other.
std::string allRows(const sweep::Sweep& sweep);

/// How many cells of the small kind have begun to run since the last call.
int cellsRun();

std::string textOf(const std::string& path);
void writeTo(const std::string& path, const std::string& text);

}  // namespace underact::test
