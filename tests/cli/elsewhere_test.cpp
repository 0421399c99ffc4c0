// What underact-cli says where it is not whole, and that it finds what belongs to it from any folder.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

namespace fs = std::filesystem;

/// A folder with the program alone in it; gone with the object.
class Alone {
 public:
  Alone() : folder_(fs::temp_directory_path() / ("underact alone " + std::to_string(::getpid()))) {
    fs::create_directories(folder_ / "odd");
    folder_ = fs::canonical(folder_);
    fs::copy_file(std::string(UNDERACT_BINARY) + "/underact-cli", folder_ / "odd/underact-cli");
  }
  ~Alone() { fs::remove_all(folder_); }
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;

  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  /// What it says with these words, both streams together, in its own folder.
  ProcessOutcome says(const std::string& words) const {
    return shell("cd '" + at("odd") + "' && env -u UNDERACT_DATA_DIR -u UNDERACT_MESH_READER UNDERACT_CACHE_DIR='" +
                 at("cache") + "' ./underact-cli " + words + " 2>&1");
  }

 private:
  fs::path folder_;
};

/// The command fails with status 4 and the sentence that names this place.
void expectNotFound(const Alone& alone, const std::string& words, const std::string& what, const std::string& place) {
  const ProcessOutcome outcome = alone.says(words);
  EXPECT_EQ(outcome.exit, 4) << words;
  EXPECT_NE(outcome.out.find(what), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(alone.at(place)), std::string::npos) << outcome.out;
}

TEST(Elsewhere, NamesAMissingFileAndThePlacesSearched) {
  const Alone alone;
  expectNotFound(alone, "lesson list", "The lessons that come with Underact were not found in",
                 "share/underact/lessons");
  expectNotFound(alone, "lesson try 01_frames --hand still", "The lessons that come with Underact were not found in",
                 "share/underact/lessons");
  expectNotFound(alone, "lesson check '" UNDERACT_SOURCE "/resources/lessons/06_statics.json'",
                 "The scenes that come with Underact were not found in", "share/underact/scenes");
  expectNotFound(alone, "lab trade", "The scenes that come with Underact were not found in", "share/underact/scenes");
  expectNotFound(alone, "lab stability --map scenes", "The scenes that come with Underact were not found in",
                 "share/underact/scenes");
  expectNotFound(alone, "figures --out f", "The Python package that comes with Underact was not found in",
                 "share/underact/python");
  expectNotFound(alone, "log plot '" UNDERACT_TEST_DATA "/golden/session.h5' --out p.png",
                 "The Python package that comes with Underact was not found in", "lib/python3/dist-packages");
}

TEST(Elsewhere, ASceneWhoseMeshNobodyCanReadSaysWhoseReaderIsMissing) {
  const Alone alone;
  const ProcessOutcome outcome = alone.says("scene check '" + shipped("26_bumpy_sphere.json") + "'");
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_NE(outcome.out.find("underact-mesh-reader was not found. Searched: " + alone.at("odd/underact-mesh-reader") +
                             ", " + alone.at("libexec/underact/underact-mesh-reader") + "."),
            std::string::npos)
      << outcome.out;
}

TEST(Elsewhere, ScenesOfTheFolderOneStandsInAreNotThoseThatShip) {
  const Alone alone;
  fs::copy_file(shipped("02_sphere.json"), alone.at("odd/02_sphere.json"));
  fs::create_directories(alone.at("odd/scenes"));
  fs::copy_file(shipped("02_sphere.json"), alone.at("odd/scenes/02_sphere.json"));
  EXPECT_EQ(alone.says("lab trade").exit, 4);
  const ProcessOutcome outcome =
      shell("cd '" + alone.at("odd") + "' && UNDERACT_DATA_DIR=. ./underact-cli lab trade 2>&1");
  EXPECT_EQ(outcome.exit, 4) << outcome.out;
}

TEST(Elsewhere, ABuildFolderOfAnyNameFindsItsSources) {
  const Alone alone;
  ASSERT_NE(alone.says("lesson list").exit, 0);
  fs::copy_file(std::string(UNDERACT_BINARY) + "/underact-places", alone.at("odd/underact-places"));
  EXPECT_NE(alone.says("lesson list").out.find("01_frames"), std::string::npos);
  EXPECT_EQ(alone.says("scene check '" + shipped("26_bumpy_sphere.json") + "'").exit, 0);
}

TEST(Elsewhere, AnInstalledFolderOfAnyNameFindsItsOwn) {
  const Alone alone;
  fs::create_directories(alone.at("share/underact"));
  fs::create_directory_symlink(std::string(UNDERACT_SOURCE) + "/resources/lessons", alone.at("share/underact/lessons"));
  EXPECT_NE(alone.says("lesson list").out.find("01_frames"), std::string::npos);
}

}  // namespace
}  // namespace underact::test
