#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>

#include "core/mesh_file/message.h"
#include "core/mesh_file/read_file.h"
#include "tests/core/mesh_file/cancelled_after.h"
#include "tests/core/mesh_file/some_meshes.h"
#include "tests/support/random.h"

namespace underact::mesh_file {
namespace {

/// Another program in the reader's place, as long as it lives.
class InPlaceOfTheReader {
 public:
  explicit InPlaceOfTheReader(const std::string& script) {
    const std::string path = folder_.write("reader", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    ::setenv("UNDERACT_MESH_READER", path.c_str(), 1);
  }
  ~InPlaceOfTheReader() { ::unsetenv("UNDERACT_MESH_READER"); }

  std::string problem(const TaskMonitor& monitor = {}) {
    const Result<RawMesh> raw = readFile(folder_.write("m.obj", test::obj(test::cube(1.0F))), monitor);
    EXPECT_FALSE(raw);
    return raw ? "" : raw.problems()[0].sentence;
  }

 private:
  test::ScratchFolder folder_;
};

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(ReaderProcess, SaysASentenceWithItsPatternsSoThatTheWindowCanSayItInItsLanguage) {
  const test::ScratchFolder folder;
  const Result<RawMesh> raw = readFile(folder.write("many.off", "OFF\n8000000000 12 0\n0 0 0\n"));
  ASSERT_FALSE(raw);
  const Sentence& sentence = raw.problems()[0].sentence;
  EXPECT_EQ(sentence.pattern(), "The file is truncated or damaged: it declares %1, but is too short for that.");
  ASSERT_EQ(sentence.places().size(), 1U);
  const Sentence& states = sentence.places()[0];
  EXPECT_EQ(states.pattern(), "%1 and %2");
  ASSERT_EQ(states.places().size(), 2U);
  EXPECT_EQ(states.places()[1].pattern(), "%1 faces");
  EXPECT_EQ(states.places()[1], "12 faces");
}

TEST(ReaderProcess, ReportsACrashInASentence) {
  EXPECT_EQ(InPlaceOfTheReader("kill -SEGV $$").problem(),
            "The file is damaged: the reader program crashed (signal 11).");
}

TEST(ReaderProcess, EndsAReaderThatHangsWithinASecond) {
  InPlaceOfTheReader reader("while :; do :; done");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(
      reader.problem(),
      "The file is damaged, or has very large faces: reading it took longer than 0.8 s, which is enough for a file "
      "of its size.");
  // 0.8 s of the processor, which a busy machine takes many times as long to give. Left alone it would hang for ever.
  EXPECT_LT(secondsSince(start), 60.0);
}

TEST(ReaderProcess, EndsAReaderThatWritesTooMuch) {
  EXPECT_EQ(InPlaceOfTheReader("exec cat /dev/zero").problem(),
            "The file is damaged: it declares more faces than a file of its size can hold.");
}

TEST(ReaderProcess, RefusesAnAnswerThatIsNoMesh) {
  const std::string lie = "The file is damaged: the reader program could not make a mesh of it.";
  EXPECT_EQ(InPlaceOfTheReader("exit 0").problem(), lie);
  EXPECT_EQ(InPlaceOfTheReader("echo hello").problem(), lie);
  EXPECT_EQ(InPlaceOfTheReader("exit 3").problem(), "The file cannot be read: the reader program exited with 3.");
}

TEST(ReaderProcess, NamesAReaderThatIsMissing) {
  ::setenv("UNDERACT_MESH_READER", "/dev/null/nowhere/reader", 1);
  const test::ScratchFolder folder;
  const Result<RawMesh> raw = readFile(folder.write("m.obj", test::obj(test::cube(1.0F))));
  ::unsetenv("UNDERACT_MESH_READER");
  ASSERT_FALSE(raw);
  EXPECT_EQ(
      raw.problems()[0].sentence,
      "underact-mesh-reader was not found. Searched: /dev/null/nowhere/reader. It reads meshes: reinstall Underact.");
}

TEST(ReaderProcess, IsEndedAtOnceWhereItIsCancelled) {
  InPlaceOfTheReader reader("while :; do :; done");
  test::CancelledAfter cancelled(std::chrono::milliseconds(100));
  EXPECT_EQ(reader.problem(cancelled.monitor()), kCancelled);
  EXPECT_LT(cancelled.secondsSince(), 0.2);
}

TEST(ReaderProcess, TellsHowFarItIs) {
  const test::ScratchFolder folder;
  double last = 0.0;
  int told = 0;
  TaskMonitor monitor;
  monitor.progress = [&](const char* /*step*/, double share) {
    EXPECT_GT(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
    ++told;
  };
  ASSERT_TRUE(readFile(folder.write("m.obj", test::obj(test::ball(1.0F, 6))), monitor));
  EXPECT_GT(told, 50);
}

TEST(Message, ThatIsDamagedAnywhereIsNoMessageOrOneThatIsWhole) {
  Message message;
  message.raw.triangles = test::ball(1.0F, 1);
  message.raw.polygons = 32;
  std::vector<std::byte> bytes;
  ASSERT_TRUE(writeMessage(message, [&bytes](std::span<const std::byte> part) {
    bytes.insert(bytes.end(), part.begin(), part.end());
    return true;
  }));
  ASSERT_TRUE(readMessage(bytes));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    ASSERT_FALSE(readMessage(std::span(bytes).first(length))) << length;
  }
  test::Random random(test::Seed{20070601});
  int whole = 0;
  for (int draw = 0; draw < 20'000; ++draw) {
    std::vector<std::byte> damaged = bytes;
    for (std::size_t count = 1 + random.below(3); count > 0; --count) {
      damaged[random.below(damaged.size())] ^= static_cast<std::byte>(1U << random.below(8));
    }
    const std::optional<Message> read = readMessage(damaged);
    if (!read) continue;
    ++whole;
    for (const mesh::Face& face : read->raw.triangles.faces) {
      for (const std::int32_t corner : face) {
        ASSERT_GE(corner, 0);
        ASSERT_LT(static_cast<std::size_t>(corner), read->raw.triangles.p_MV.size());
      }
    }
    for (const Eigen::Vector3f& p_MV : read->raw.triangles.p_MV) ASSERT_TRUE(p_MV.allFinite());
  }
  EXPECT_GT(whole, 1000);
}

}  // namespace
}  // namespace underact::mesh_file
