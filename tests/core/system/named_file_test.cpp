#include "core/system/named_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/odd_files.h"
#include "tests/support/watchdog.h"

namespace underact::system {
namespace {

constexpr std::uint64_t kMax = std::uint64_t{1} << 20;

Sentence problemOf(const std::string& path) {
  const Result<NamedFile> file = NamedFile::open(path, "a scene");
  if (!file) return file.problems().at(0).sentence;
  const Result<std::string> text = file.value().readAll(kMax);
  return text ? Sentence() : text.problems().at(0).sentence;
}

TEST(NamedFile, RefusesWhatIsNoRegularFileAtOnceWithAdvice) {
  const test::Watchdog watchdog;
  const test::ScratchFolder folder;
  const std::string odd =
      "This is a pipe, a device or a socket, not a regular file, so a scene is not read from it. Save its output to a "
      "file, and give that file.";
  const std::vector<std::string> expected{odd,
                                          odd,
                                          odd,
                                          odd,
                                          odd,
                                          "This is a folder, not a scene file.",
                                          "The file cannot be opened: No such file or directory.",
                                          "The file is larger than 1 MiB; a scene is far smaller."};
  const std::vector<test::OddFile> files = test::oddFiles(folder, ".json");
  ASSERT_EQ(files.size(), expected.size());
  for (std::size_t at = 0; at < files.size(); ++at)
    EXPECT_EQ(problemOf(files[at].path), expected[at]) << files[at].what;
  const Problems problems = NamedFile::open(files[0].path, "a scene").problems();
  EXPECT_EQ(describe(problems[0]).find(files[0].path), 0U);
}

TEST(NamedFile, IsReadWholeAndALinkToItToo) {
  const test::ScratchFolder folder;
  const std::string long_text(3 * 65536 + 17, 'x');
  for (const std::string& text : {std::string(), std::string("a\0b", 3), std::string(65536, 'y'), long_text}) {
    const std::string path = folder.write("file", text);
    EXPECT_EQ(NamedFile::open(path, "a scene").value().readAll(kMax).value(), text);
  }
  std::filesystem::create_symlink(folder.file("file"), folder.file("link"));
  const Result<NamedFile> linked = NamedFile::open(folder.file("link"), "a scene");
  ASSERT_TRUE(linked);
  EXPECT_EQ(linked.value().readAll(long_text.size()).value(), long_text);
  linked.value().rewind();
  std::string begin(5, '\0');
  EXPECT_EQ(linked.value().read(begin).value(), 5U);
  EXPECT_EQ(begin, "xxxxx");
}

TEST(NamedFile, RefusesAFileThatChangesWhileItIsRead) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("file", "{}");
  const Result<NamedFile> file = NamedFile::open(path, "a scene");
  std::ofstream(path, std::ios::app) << " ";
  const Result<std::string> text = file.value().readAll(kMax);
  ASSERT_FALSE(text);
  EXPECT_EQ(text.problems()[0].sentence,
            "Another program wrote to the file while it was being read. Open it again once that program has saved it.");
}

TEST(NamedFile, OneByteTooManyIsTooLarge) {
  const test::ScratchFolder folder;
  EXPECT_EQ(problemOf(folder.write("file", std::string(kMax, ' '))), "");
  EXPECT_EQ(problemOf(folder.write("file", std::string(kMax + 1, ' '))),
            "The file is larger than 1 MiB; a scene is far smaller.");
}

}  // namespace
}  // namespace underact::system
