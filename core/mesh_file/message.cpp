#include "core/mesh_file/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/mesh_file/limits.h"

namespace underact::mesh_file {
namespace {

constexpr std::array<char, 8> kMessageMagic{'\x89', 'M', 'E', 'S', 'H', '1', '\r', '\n'};  // the first is no progress
constexpr std::uint64_t kLongestProblem = 500;
constexpr std::uint64_t kMostFaces = std::uint64_t{1} << 27;  // as a surface takes them

struct MessageHead {
  std::array<char, 8> magic = kMessageMagic;
  std::uint64_t problem_bytes = 0, corners = 0, faces = 0;
  std::int64_t not_finite = 0, out_of_range = 0, without_extent = 0;
  std::int64_t polygons = 0, normals = 0, normals_against = 0, peak_bytes = 0;
};
static_assert(std::is_trivially_copyable_v<MessageHead>);
static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(mesh::Face) == 12);

// Of a sentence: how many places it has, its pattern, the end of the line; then those in its places, likewise.
constexpr char kEnd = '\n';
constexpr int kMostPlaces = 9;

std::string plain(std::string text) {
  for (char& c : text) c = c >= ' ' && c <= '~' ? c : '?';
  return text;
}

std::string lettersOf(const Sentence& sentence) {
  std::string text(1, static_cast<char>('0' + sentence.places().size()));
  text += plain(sentence.pattern().empty() ? std::string(sentence) : sentence.pattern()) + kEnd;
  for (const Sentence& place : sentence.places()) text += lettersOf(place);
  return text;
}

/// The first sentence of the letters, which are taken off: each call takes a line, so that it comes to an end.
Sentence takeSentence(std::string_view& letters) {
  if (letters.empty()) return {};
  const std::string line(letters.substr(0, letters.find(kEnd)));
  letters.remove_prefix(std::min(line.size() + 1, letters.size()));
  const int places = line.empty() ? 0 : std::clamp(line.front() - '0', 0, kMostPlaces);
  std::vector<Sentence> in_places;
  for (int place = 0; place < places; ++place) in_places.push_back(takeSentence(letters));
  return said(plain(line.substr(std::min<std::size_t>(1, line.size()))), std::move(in_places));
}

bool isWhole(const Raw& raw) {
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
  const std::array<std::int64_t, 6> counts{
      raw.dropped.not_finite, raw.dropped.out_of_range, raw.dropped.without_extent, raw.polygons, raw.normals,
      raw.normals_against};
  return std::all_of(counts.begin(), counts.end(), [](std::int64_t value) { return value >= 0; });
}

}  // namespace

bool writeMessage(const Message& message, const std::function<bool(std::span<const std::byte>)>& write) {
  const Raw& raw = message.raw;
  const std::string problem =
      message.problem.empty() ? std::string() : lettersOf(message.problem).substr(0, kLongestProblem);
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
  return write(std::as_bytes(std::span(&head, 1))) && write(std::as_bytes(std::span(problem))) &&
         write(std::as_bytes(std::span(raw.triangles.p_MV))) && write(std::as_bytes(std::span(raw.triangles.faces)));
}

std::optional<Message> readMessage(std::span<const std::byte> bytes) {
  MessageHead head;
  if (bytes.size() < sizeof head) return {};
  std::memcpy(&head, bytes.data(), sizeof head);
  if (head.magic != kMessageMagic || head.problem_bytes > kLongestProblem || head.faces > kMostFaces ||
      head.corners > 3 * kMostFaces) {
    return {};
  }
  if (bytes.size() != sizeof head + head.problem_bytes + 12 * (head.corners + head.faces)) return {};
  Message message;
  bytes = bytes.subspan(sizeof head);
  std::string_view letters{reinterpret_cast<const char*>(bytes.data()), head.problem_bytes};
  message.problem = takeSentence(letters);
  bytes = bytes.subspan(head.problem_bytes);
  Raw& raw = message.raw;
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
  if (!isWhole(raw)) return {};
  return message;
}

}  // namespace underact::mesh_file
