// Mesh files that are damaged in every way: through the reading program, as a user's file would go.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/mesh_file/limits.h"
#include "core/mesh_file/read_file.h"
#include "tests/core/mesh_file/some_meshes.h"
#include "tests/support/property.h"

namespace underact::test {
namespace {

using mesh_file::RawMesh;

constexpr std::size_t kLongestMesh = 40'000;

struct Kind {
  const char* name;
  const char* extension;
  bool is_text;
  std::vector<std::string> seeds;
};

std::vector<mesh::Triangles> someMeshes() {
  return {cube(10.0F), ball(3.0F, 1), joined(cube(1.0F), sheet(3)), soup(cube(0.1F))};
}

template <class Write>
std::vector<std::string> written(Write write) {
  std::vector<std::string> seeds;
  for (const mesh::Triangles& triangles : someMeshes()) seeds.push_back(write(triangles));
  return seeds;
}

std::vector<Kind> theKinds() {
  std::vector<Kind> kinds{
      {"stl_binary", "stl", false, written([](const auto& mesh) { return stlBinary(mesh); })},
      {"stl_text", "stl", true, written(stlText)},
      {"obj", "obj", true, written(obj)},
      {"ply_text", "ply", true, written(plyText)},
      {"ply_binary", "ply", false, written([](const auto& mesh) { return plyBinary(mesh); })},
      {"off", "off", true, written(off)},
  };
  kinds[2].seeds.push_back("v 0 0 0\nv 1 0 0 \\\n\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf -4/1/1 -3/1 -2//1 -1\n");
  kinds[3].seeds.push_back(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
      "red\nelement face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n0 "
      "0 "
      "0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2 2 0.5 0.5\n");
  kinds[4].seeds.push_back(plyBinary(cube(1.0F), true));
  kinds[5].seeds.push_back("STCNOFF\n3 1 0\n0 0 0 1 1 1\n1 0 0 # x\n0 1 0\n3 0 1 2 255 0 0\n");
  return kinds;
}

/// One file made of others by a seed: bytes, numbers, words, cuts, splices, repetitions.
class MeshMutator {
 public:
  MeshMutator(const Kind& kind, Seed seed) : kind_(kind), random_(seed) {}

  std::string next() {
    std::string bytes = any(kind_.seeds);
    for (std::size_t count = 1 + random_.below(4); count > 0; --count) mutate(bytes);
    if (bytes.size() > kLongestMesh) bytes.resize(kLongestMesh);
    return bytes;
  }

 private:
  template <class List>
  typename List::value_type any(const List& list) {
    return list[random_.below(list.size())];
  }
  std::size_t placeIn(const std::string& bytes) { return random_.below(bytes.size() + 1); }

  void mutate(std::string& bytes) {
    switch (random_.below(8)) {
      case 0:
      case 1:
        return changeByte(bytes);
      case 2:
        return kind_.is_text ? changeNumber(bytes) : changeWord(bytes);
      case 3:
        return changeHeader(bytes);
      case 4:
        if (random_.below(3) == 0) bytes.resize(placeIn(bytes));
        return;
      case 5:
        return splice(bytes);
      case 6:
        return repeat(bytes);
      default:
        return insertToken(bytes);
    }
  }

  void changeByte(std::string& bytes) {
    if (bytes.empty()) return;
    char& byte = bytes[random_.below(bytes.size())];
    byte = random_.below(2) == 0 ? static_cast<char>(random_.bits())
                                 : static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << random_.below(8)));
  }

  void changeNumber(std::string& bytes) {
    static const std::vector<const char*> kNumbers{
        "0",    "-1", "4294967295", "2147483648", "-2147483649", "1e999", "nan", "-inf",   "1e-999",
        "1e38", "3",  "1000",       "4",          "1000000000",  "0x10",  "1,5", "1.#INF", ""};
    static const char* const kDigits = "0123456789.eE+-";
    std::size_t start = bytes.find_first_of(kDigits, placeIn(bytes));
    if (start == std::string::npos) start = bytes.find_first_of(kDigits);
    if (start == std::string::npos) return;
    const std::size_t end = std::min(bytes.find_first_not_of(kDigits, start), bytes.size());
    bytes.replace(start, end - start, any(kNumbers));
  }

  /// Four bytes, as a whole number or a float.
  void changeWord(std::string& bytes) {
    static const std::vector<std::uint32_t> kWords{
        0, 1, 3, 0x7FC00000, 0x7F800000, 0xFF800000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x00000001, 0x7F7FFFFF, 1000};
    if (bytes.size() < 4) return;
    bytes.replace(random_.below(bytes.size() - 3), 4, bytesOf(any(kWords)));
  }

  void changeHeader(std::string& bytes) {
    const std::size_t end = std::min<std::size_t>(bytes.size(), kind_.is_text ? 250 : 90);
    std::string head = bytes.substr(0, end);
    random_.below(2) == 0 ? changeNumber(head) : changeByte(head);
    bytes.replace(0, end, head);
  }

  void splice(std::string& bytes) {
    const std::string other = any(kind_.seeds);
    const std::size_t from = placeIn(other), at = placeIn(bytes);
    const std::size_t length = random_.below(std::min<std::size_t>(other.size() - from, 2000) + 1);
    bytes.replace(at, random_.below(std::min<std::size_t>(bytes.size() - at, 200) + 1), other.substr(from, length));
  }

  void repeat(std::string& bytes) {
    const std::size_t from = placeIn(bytes);
    const std::string span = bytes.substr(from, random_.below(300));
    for (std::size_t times = random_.below(60); times > 0 && bytes.size() < kLongestMesh; --times)
      bytes.insert(from, span);
  }

  void insertToken(std::string& bytes) {
    static const std::vector<const char*> kTokens{"\n",
                                                  "\r\n",
                                                  " ",
                                                  "#",
                                                  "f ",
                                                  "v ",
                                                  "3 0 1 2\n",
                                                  "facet ",
                                                  "outer loop\n",
                                                  "endfacet ",
                                                  "vertex ",
                                                  "solid ",
                                                  "endsolid ",
                                                  "end_header\n",
                                                  "element face 5\n",
                                                  "OFF ",
                                                  "BINARY",
                                                  "\\\n",
                                                  "mtllib /dev/zero\n",
                                                  "property list int int vertex_indices\n",
                                                  "property float x\n",
                                                  "-1 ",
                                                  "/",
                                                  "nan "};
    bytes.insert(placeIn(bytes), any(kTokens));
  }

  const Kind& kind_;
  Random random_;
};

/// What is wrong with how a file was taken; empty: nothing.
std::string judgeRaw(const Result<RawMesh>& raw) {
  if (!raw) {
    if (raw.problems().size() != 1 || raw.problems()[0].sentence.size() < 15) return "no sentence";
    const Sentence& sentence = raw.problems()[0].sentence;
    if (sentence.pattern().empty()) return "no other language can say: " + sentence;
    for (const char* word : {"reader program crashed", "took longer", "reader program exited", "could not make a mesh",
                             "cannot be started"}) {
      // What ended the reading program is no danger, and yet a mistake of it.
      if (sentence.find(word) != std::string::npos) return sentence;
    }
    return {};
  }
  const mesh::Triangles& triangles = raw.value().triangles;
  for (const Eigen::Vector3f& p_MV : triangles.p_MV) {
    if (!p_MV.allFinite()) return "a corner is not finite";
  }
  for (const mesh::Face& face : triangles.faces) {
    for (const std::int32_t corner : face) {
      if (corner < 0 || static_cast<std::size_t>(corner) >= triangles.p_MV.size()) return "a corner is not there";
    }
  }
  return {};
}

Result<RawMesh> timedRead(const std::string& path, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  Result<RawMesh> raw = mesh_file::readFile(path);
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return raw;
}

class MeshMutations : public testing::TestWithParam<std::size_t> {};

TEST_P(MeshMutations, AreReadOrRefusedInTimeAndInMemory) {
  ::setenv("UNDERACT_MESH_READER", UNDERACT_READER, 1);
  const Kind kind = theKinds()[GetParam()];
  const char* stated = std::getenv("UNDERACT_MUTATIONS");
  const int count = stated != nullptr ? std::atoi(stated) : sweep(500, 100'000);
  const ScratchFolder folder;
  MeshMutator mutator(kind, Seed{20070601 + GetParam()});
  int accepted = 0;
  double longest_s = 0.0, longest_cpu_s = 0.0;
  std::int64_t peak_bytes = 0;
  for (int draw = 0; draw < count; ++draw) {
    const std::string bytes = mutator.next();
    const std::string path = folder.write(std::string("m.") + kind.extension, bytes);
    double seconds = 0.0;
    Result<RawMesh> raw = timedRead(path, seconds);
    if (seconds > 1.0) raw = timedRead(path, seconds);  // on a busy machine; what hangs, hangs again
    longest_s = std::max(longest_s, seconds);
    ASSERT_EQ(judgeRaw(raw), "") << "mutation " << draw;
    if (!raw) continue;
    ++accepted;
    longest_cpu_s = std::max(longest_cpu_s, raw.value().cpu_s);
    peak_bytes = std::max(peak_bytes, raw.value().peak_bytes);
#ifndef __SANITIZE_ADDRESS__
    ASSERT_LE(raw.value().peak_bytes, static_cast<std::int64_t>(mesh_file::maxMemory(bytes.size())));
#endif
  }
  std::printf("%s: %d files, %d of them read, the rest refused; longest %.3f s (%.3f s of the processor), %.1f MiB\n",
              kind.name, count, accepted, longest_s, longest_cpu_s, static_cast<double>(peak_bytes) / (1 << 20));
  EXPECT_LT(longest_s, 1.0);
  // A mutator that only makes rubbish, or nothing new, would prove nothing.
  EXPECT_GT(accepted, count / 50);
  EXPECT_LT(accepted, count);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshMutations, testing::Range<std::size_t>(0, 6),
                         [](const auto& index) { return std::string(theKinds()[index.param].name); });

}  // namespace
}  // namespace underact::test
