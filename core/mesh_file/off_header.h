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

/// "OFF", with the letters before it that say what a line holds more than is read here.
bool isOffKeyword(std::string_view word);

/// Problems: one, without a file.
Result<OffHeader> readOffHeader(std::string_view head);

}  // namespace underact::mesh_file
