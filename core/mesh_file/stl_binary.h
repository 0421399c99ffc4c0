#pragma once
#include <cstdint>
#include <cstring>
#include <string_view>

namespace underact::mesh_file {

// 80 arbitrary bytes, the number of faces, and for each face its normal, three corners and two arbitrary bytes;
// little-endian.
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

/// Whether the size fits the stated number of faces: this tells it from text, which may begin alike.
inline bool isWholeStlBinary(std::string_view head, std::uint64_t file_bytes) {
  return file_bytes >= kStlHeadBytes && file_bytes == kStlHeadBytes + stlBinaryCount(head) * kStlFaceBytes;
}

}  // namespace underact::mesh_file
