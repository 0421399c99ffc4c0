#include "core/sweep/result_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "core/json/text.h"
#include "core/system/file.h"

namespace underact::sweep {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestResult = std::size_t{8} << 30U;
const std::string kGoOn = "Move it away and run the same command again: the cells are kept.";

/// Removes the file `beside`, if it is a part of text left by a program that was killed. Problems: it is something
/// else.
Problems removeTorn(const std::string& beside, std::string_view text) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(beside, ignored))) return {};
  const bool is_plain = fs::is_regular_file(fs::symlink_status(beside, ignored));
  const Result<std::string> found =
      is_plain ? json::readTextFile(beside, "a part of a result", kLargestResult) : Problems{};
  if (!found || !text.starts_with(found.value()))
    return problemAt(beside,
                     "The result is written here first, but another file is here and is not overwritten. " + kGoOn);
  std::remove(beside.c_str());
  return {};
}

}  // namespace

Result<bool> isThere(const Sweep& sweep, const std::string& path) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(path, ignored))) return false;
  if (!fs::is_regular_file(path, ignored)) return problemAt(path, "This is not a regular file; choose another --out.");
  const Result<std::string> text = json::readTextFile(path, "a result", kLargestResult);
  if (!text) return text.problems();
  if (text.value().starts_with(sweep.header)) {
    const auto lines = std::count(text.value().begin(), text.value().end(), '\n');
    const auto header = std::count(sweep.header.begin(), sweep.header.end(), '\n');
    if (static_cast<std::size_t>(lines - header) == sweep.cells.count) return true;
    return problemAt(path,
                     "Rows of this result were removed or added since it was written. Remove it to make it again.");
  }
  return problemAt(path, "Another file exists here and is not overwritten. Choose another --out, or remove it.");
}

Problems writeResult(const Sweep& sweep, const Rows& rows, const std::string& path) {
  std::string text = sweep.header;
  for (const auto& [cell, row] : rows) text += row + "\n";
  const std::string beside = path + ".new";
  Problems in_the_way = removeTorn(beside, text);
  if (!in_the_way.empty()) return in_the_way;
  system::Descriptor made = system::makeFile(beside, system::Making::New, system::Readers::Default);
  const bool is_made = made.isOpen();
  int error = is_made ? system::writeAll(made.number(), std::as_bytes(std::span(text))) : errno;
  if (error == 0) error = system::sync(made.number());
  if (const int late = made.close(); error == 0) error = late;
  // On the disk before it has its name: a name without contents would pass for a result.
  if (error == 0) error = system::renameIfFree(beside, path);
  if (is_made && error != 0) std::remove(beside.c_str());
  if (error == 0) {
    system::syncFolderOf(path);  // before the journal is removed
    return {};
  }
  if (error == EEXIST)
    return problemAt(path, "Another file was put here while the sweep ran, and is not overwritten. " + kGoOn);
  return problemAt(path, "The result cannot be written: " + std::generic_category().message(error) +
                             ". Its cells are kept: free some space and run the same command again.");
}

}  // namespace underact::sweep
