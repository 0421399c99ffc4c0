#pragma once
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "app/mesh_reader/prepare.h"
#include "core/mesh_file/limits.h"
#include "core/mesh_file/scan.h"

namespace underact::mesh_reader {

/// Appends a number and a space, moved by the shift if it is a coordinate of a corner; kNoNumber for one that is not
/// finite or too large. false: it is not a number.
inline bool addNumber(std::string_view word, std::string& to, Shift* shift = nullptr, int axis = 0) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || read.ec == std::errc::invalid_argument) return false;
  const bool is_whole = read.ptr == word.data() + word.size();
  if (!is_whole && word.find('#') == std::string_view::npos) return false;  // 1.#QNAN and 1.#INF are from Windows
  if (is_whole && read.ec == std::errc() && std::abs(value) < mesh_file::kBeyondAll) {
    const double moved = shift != nullptr ? shift->take(axis, value) : value;
    if (moved == value) {
      to.append(word).push_back(' ');
    } else {
      std::array<char, 32> digits{};
      const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), moved).ptr;
      to.append(digits.data(), end).push_back(' ');
    }
    return true;
  }
  const bool is_tiny = read.ec == std::errc::result_out_of_range && word.find('-', 1) != std::string_view::npos;
  to.append(is_tiny ? "0" : kNoNumber).push_back(' ');
  return true;
}

/// Appends three coordinates and the end of the line. shift: for those of a corner.
inline bool addPoint(mesh_file::Scan& words, std::string& to, Shift* shift = nullptr) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!addNumber(words.word(), to, shift, axis)) return false;
  }
  to.back() = '\n';
  return true;
}

}  // namespace underact::mesh_reader
