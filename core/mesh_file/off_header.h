#pragma once
#include <cstdint>
#include <string_view>

#include "core/base/result.h"

namespace underact::mesh_file {

/// What the head of an OFF file states.
struct OffHeader {
  std::uint64_t corners = 0, faces = 0;
  std::size_t bytes = 0;  // where the first line of a corner begins
  int lines = 1;          // and its number
};

/// Whether the word is "OFF", with prefix letters for what a line holds beyond what is read here.
bool isOffKeyword(std::string_view word);

/// Reads the head of an OFF file. Problems: one, whose place has no file.
Result<OffHeader> readOffHeader(std::string_view head);

}  // namespace underact::mesh_file
