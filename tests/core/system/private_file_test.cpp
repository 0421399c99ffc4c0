#include "core/system/private_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "core/system/file.h"
#include "tests/support/modes.h"
#include "tests/support/odd_files.h"

namespace underact::system {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(MakeNew, IsItsOwnersAloneWhateverTheUmaskIs) {
  const test::ScratchFolder folder;
  for (const mode_t mask : {0U, 022U, 077U, 0577U}) {
    const test::Umask umask(mask);
    const Descriptor file = makeNew(folder.file("new"), Existing::Replace);
    ASSERT_TRUE(file.isOpen());
    EXPECT_EQ(test::modeOf(folder.file("new")) & 0077U, 0U) << mask;
  }
}

TEST(MakeNew, NothingOfThatNameIsTouchedUnlessItIsToBeReplaced) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("file", "mine"), link = folder.file("link"), dangling = folder.file("dangling");
  fs::create_symlink(file, link);
  fs::create_symlink(folder.file("nowhere"), dangling);
  for (const std::string& path : {file, link, dangling}) {
    EXPECT_EQ(checkNew(path, Existing::Refuse).at(0).sentence,
              "A file or a link of this name already exists; it was left unchanged. Give another name.");
    EXPECT_FALSE(makeNew(path, Existing::Refuse).isOpen());
    EXPECT_EQ(errno, EEXIST);
  }
  EXPECT_EQ(contentOf(file), "mine");
  EXPECT_FALSE(fs::exists(folder.file("nowhere")));
}

TEST(MakeNew, ReplacingTakesALinkAwayAndNotWhatItLeadsTo) {
  const test::ScratchFolder folder;
  const std::string target = folder.write("target", "mine"), link = folder.file("link");
  fs::create_symlink(target, link);
  ASSERT_TRUE(checkNew(link, Existing::Replace).empty());
  {
    const Descriptor made = makeNew(link, Existing::Replace);
    ASSERT_TRUE(made.isOpen());
    EXPECT_EQ(::write(made.number(), "new", 3), 3);
  }
  EXPECT_FALSE(fs::is_symlink(link));
  EXPECT_EQ(contentOf(link), "new");
  EXPECT_EQ(contentOf(target), "mine");
}

TEST(MakeNew, FoldersPipesAndDevicesAreNeverReplaced) {
  const test::ScratchFolder folder;
  for (const test::OddFile& odd : test::oddFiles(folder, "")) {
    if (odd.what == "no file" || odd.what == "1 TiB of nothing" || fs::is_symlink(odd.path)) continue;
    ASSERT_EQ(checkNew(odd.path, Existing::Replace).size(), 1U) << odd.what;
    EXPECT_FALSE(makeNew(odd.path, Existing::Replace).isOpen()) << odd.what;
    EXPECT_TRUE(fs::exists(odd.path)) << odd.what;
  }
}

TEST(NameOf, OpensTheOneThatWasMadeAlsoWhereAnotherStandsAtItsName) {
  const test::ScratchFolder folder;
  const Descriptor made = makeNew(folder.file("new"), Existing::Refuse);
  const std::string same = nameOf(made.number(), folder.file("new"));
  if (same == folder.file("new")) GTEST_SKIP() << "this system has no /proc";
  const std::string target = folder.write("target", "mine");
  fs::remove(folder.file("new"));
  fs::create_symlink(target, folder.file("new"));
  std::ofstream(same) << "recorded";
  EXPECT_EQ(contentOf(target), "mine");
  EXPECT_EQ(contentOf(same), "recorded");
}

TEST(PrivateFolder, ThoseThatAreMadeAreTheirOwnersAlone) {
  const test::ScratchFolder folder;
  const test::Umask umask(0);
  fs::create_directory(folder.file("open"));
  fs::permissions(folder.file("open"), fs::perms(0755));
  EXPECT_EQ(makePrivateFolder(folder.file("open/a/b")), 0);
  EXPECT_EQ(test::modeOf(folder.file("open")), 0755U);
  EXPECT_EQ(test::modeOf(folder.file("open/a")), 0700U);
  EXPECT_EQ(test::modeOf(folder.file("open/a/b")), 0700U);
  EXPECT_EQ(makePrivateFolder(folder.file("open/a/b/")), 0);
  EXPECT_EQ(makePrivateFolder(folder.write("file", "") + "/below"), ENOTDIR);
}

}  // namespace
}  // namespace underact::system
