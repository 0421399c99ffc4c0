#pragma once
#include <cmath>
#include <string>
#include <string_view>

#include "app/mesh_reader/prepare.h"
#include "core/mesh_file/limits.h"
#include "core/mesh_file/scan.h"

namespace underact::mesh_reader {

/// Appends a coordinate and a space; kNoNumber for one that is not finite or too large. false: it is not a number.
inline bool addNumber(std::string_view word, std::string& to) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || read.ec == std::errc::invalid_argument) return false;
  const bool is_whole = read.ptr == word.data() + word.size();
  if (!is_whole && word.find('#') == std::string_view::npos) return false;  // 1.#QNAN and 1.#INF are from Windows
  if (is_whole && read.ec == std::errc() && std::abs(value) < mesh_file::kBeyondAll) {
    to.append(word).push_back(' ');
    return true;
  }
  const bool is_tiny = read.ec == std::errc::result_out_of_range && word.find('-', 1) != std::string_view::npos;
  to.append(is_tiny ? "0" : kNoNumber).push_back(' ');
  return true;
}

/// Appends three coordinates and the end of the line.
inline bool addPoint(mesh_file::Scan& words, std::string& to) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!addNumber(words.word(), to)) return false;
  }
  to.back() = '\n';
  return true;
}

}  // namespace underact::mesh_reader
