#include "core/mesh_file/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/helper/sentence_codec.h"
#include "core/mesh_file/limits.h"

namespace underact::mesh_file {
namespace {

constexpr std::array<char, 8> kMessageMagic{'\x89', 'M', 'E', 'S', 'H', '2', '\r', '\n'};  // no progress
constexpr std::uint64_t kMaxFaces = std::uint64_t{1} << 27;                                // as a surface takes them

struct MessageHead {
  std::array<char, 8> magic = kMessageMagic;
  std::uint64_t problem_bytes = 0, corners = 0, faces = 0;
  std::int64_t not_finite = 0, out_of_range = 0, without_extent = 0;
  std::int64_t polygons = 0, normals = 0, normals_against = 0, peak_bytes = 0;
  std::array<double, 3> origin_M{};
  double single_step = 0.0;
};
static_assert(std::is_trivially_copyable_v<MessageHead>);
static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(mesh::Face) == 12);

bool isWhole(const RawMesh& raw) {
  const auto count = static_cast<std::int32_t>(raw.triangles.p_MV.size());
  for (const Eigen::Vector3f& p_MV : raw.triangles.p_MV) {
    for (const float x : {p_MV.x(), p_MV.y(), p_MV.z()}) {
      if (!(std::abs(x) < kBeyondAll)) return false;
    }
  }
  for (const mesh::Face& face : raw.triangles.faces) {
    for (const std::int32_t corner : face) {
      if (corner < 0 || corner >= count) return false;
    }
  }
  if (!(raw.origin_M.cwiseAbs().maxCoeff() < static_cast<double>(kBeyondAll))) return false;
  if (!(raw.single_step >= 0.0 && raw.single_step < static_cast<double>(kBeyondAll))) return false;
  const std::array<std::int64_t, 6> counts{
      raw.dropped.not_finite, raw.dropped.out_of_range, raw.dropped.without_extent, raw.polygons, raw.normals,
      raw.normals_against};
  return std::all_of(counts.begin(), counts.end(), [](std::int64_t value) { return value >= 0; });
}

}  // namespace

bool writeMessage(const Message& message, const std::function<bool(std::span<const std::byte>)>& write) {
  const RawMesh& raw = message.raw;
  const std::string problem = helper::encodeSentence(message.problem);
  MessageHead head;
  head.problem_bytes = problem.size();
  head.corners = raw.triangles.p_MV.size();
  head.faces = raw.triangles.faces.size();
  head.not_finite = raw.dropped.not_finite;
  head.out_of_range = raw.dropped.out_of_range;
  head.without_extent = raw.dropped.without_extent;
  head.polygons = raw.polygons;
  head.normals = raw.normals;
  head.normals_against = raw.normals_against;
  head.peak_bytes = raw.peak_bytes;
  head.single_step = raw.single_step;
  head.origin_M = {raw.origin_M.x(), raw.origin_M.y(), raw.origin_M.z()};
  return write(std::as_bytes(std::span(&head, 1))) && write(std::as_bytes(std::span(problem))) &&
         write(std::as_bytes(std::span(raw.triangles.p_MV))) && write(std::as_bytes(std::span(raw.triangles.faces)));
}

std::optional<Message> readMessage(std::span<const std::byte> bytes) {
  MessageHead head;
  if (bytes.size() < sizeof head) return {};
  std::memcpy(&head, bytes.data(), sizeof head);
  if (head.magic != kMessageMagic || head.problem_bytes > helper::kMaxLetters || head.faces > kMaxFaces ||
      head.corners > 3 * kMaxFaces) {
    return {};
  }
  if (bytes.size() != sizeof head + head.problem_bytes + 12 * (head.corners + head.faces)) return {};
  Message message;
  bytes = bytes.subspan(sizeof head);
  std::string_view letters{reinterpret_cast<const char*>(bytes.data()), head.problem_bytes};
  std::optional<Sentence> problem = helper::decodeSentence(letters);
  if (!problem) return {};
  message.problem = std::move(*problem);
  bytes = bytes.subspan(head.problem_bytes);
  RawMesh& raw = message.raw;
  raw.triangles.p_MV.resize(head.corners);
  raw.triangles.faces.resize(head.faces);
  std::ranges::copy(bytes.first(12 * head.corners), std::as_writable_bytes(std::span(raw.triangles.p_MV)).begin());
  bytes = bytes.subspan(12 * head.corners);
  std::ranges::copy(bytes, std::as_writable_bytes(std::span(raw.triangles.faces)).begin());
  raw.dropped = {head.not_finite, head.out_of_range, head.without_extent};
  raw.polygons = head.polygons;
  raw.normals = head.normals;
  raw.normals_against = head.normals_against;
  raw.peak_bytes = head.peak_bytes;
  raw.origin_M = Vec3(head.origin_M.data());
  raw.single_step = head.single_step;
  if (!isWhole(raw)) return {};
  return message;
}

}  // namespace underact::mesh_file
