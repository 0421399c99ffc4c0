#pragma once
#include <cstdint>
#include <cstring>
#include <string_view>

namespace underact::mesh_file {

// 80 bytes of anything, the count of faces, and of each face its normal, three corners and two bytes of anything; all
// of it with the low byte first.
inline constexpr std::uint64_t kStlHeadBytes = 84;
inline constexpr std::uint64_t kStlFaceBytes = 50;

/// The count of faces that the head of a file states; 0 where the head is shorter than kStlHeadBytes.
inline std::uint64_t stlBinaryCount(std::string_view head) {
  if (head.size() < kStlHeadBytes) return 0;
  std::uint64_t count = 0;
  for (int byte = 3; byte >= 0; --byte) {
    count = count << 8U | static_cast<unsigned char>(head[80 + static_cast<std::size_t>(byte)]);
  }
  return count;
}

/// The size is that of as many faces as are stated: what tells it from text, which may begin alike.
inline bool isWholeStlBinary(std::string_view head, std::uint64_t file_bytes) {
  return file_bytes >= kStlHeadBytes && file_bytes == kStlHeadBytes + stlBinaryCount(head) * kStlFaceBytes;
}

}  // namespace underact::mesh_file
