// Recovering works on a copy: what fails changes nothing.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/record/session.h"
#include "tests/session/rig.h"
#include "tests/support/full_disk.h"
#include "tests/support/modes.h"

namespace underact::record {
namespace {

std::string contentAt(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A session that nobody has ended, with a mode of its own.
void leaveOpen(const std::string& path) {
  SessionWriter writer = SessionWriter::create(path, {}).value();
  EXPECT_TRUE(writer.begin(0, 0, {}, test::sphereScene()).empty());
  servo::TickRecord record;
  for (record.tick = 0; record.tick < 1000; ++record.tick) EXPECT_TRUE(writer.add(record).empty());
  EXPECT_TRUE(writer.flush().empty());
  writer.abandon();
  std::filesystem::permissions(path, std::filesystem::perms(0640));
}

}  // namespace

TEST(Recovery, KeepsTheModeAndLeavesNoCopy) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("s.h5"), left = folder.write("s.h5.part", "of a recovery that was killed");
  leaveOpen(path);
  const Result<std::int64_t> ticks = recover(path);
  ASSERT_TRUE(ticks) << ticks.problems().front().sentence;
  EXPECT_EQ(ticks.value(), 1000);
  EXPECT_TRUE(Session::open(path).value().info().isComplete());
  EXPECT_EQ(test::modeOf(path), 0640U);
  EXPECT_FALSE(std::filesystem::exists(left));
}

TEST(Recovery, WithoutRoomForTheCopySaysSoAndChangesNothing) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("s.h5");
  leaveOpen(path);
  const std::string before = contentAt(path);
  {
    const test::FullDisk full(100'000);
    const Result<std::int64_t> ticks = recover(path);
    ASSERT_FALSE(ticks);
    EXPECT_NE(ticks.problems().front().sentence.find("Nothing was changed."), std::string::npos);
  }
  EXPECT_EQ(contentAt(path), before);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(Recovery, OfAFileThatCannotBeRecoveredLeavesItsReadableTicks) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("s.h5");
  std::filesystem::copy(std::string(UNDERACT_SOURCE) + "/tests/session/unrecoverable.h5", path);
  const std::string before = contentAt(path);
  const std::int64_t readable = Session::open(path).value().info().ticks;
  EXPECT_FALSE(recover(path));
  EXPECT_EQ(contentAt(path), before);
  EXPECT_EQ(Session::open(path).value().info().ticks, readable);
}

}  // namespace underact::record
