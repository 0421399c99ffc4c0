#include "core/system/resource_paths.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace underact::system {
namespace {

namespace fs = std::filesystem;
using Places = std::vector<std::string>;

/// A folder that is gone with the object.
class Home {
 public:
  Home() : path_(fs::temp_directory_path() / ("underact_places_" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
    path_ = fs::canonical(path_);
  }
  ~Home() { fs::remove_all(path_); }
  Home(const Home&) = delete;
  Home& operator=(const Home&) = delete;
  std::string at(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, fs::perms rights = fs::perms::owner_read) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << "{}";
    fs::permissions(path_ / name, rights, fs::perm_options::add);
  }

 private:
  fs::path path_;
};

TEST(Places, OfAnInstalledProgramAreRelativeToIt) {
  const SearchRoots from{.here = "/opt/underact/bin"};
  EXPECT_EQ(searchFolders(Resource::Scenes, from), Places{"/opt/underact/share/underact/scenes"});
  EXPECT_EQ(searchFolders(Resource::Guide, from), Places{"/opt/underact/share/underact/guide"});
  EXPECT_EQ(searchFolders(Resource::Python, from),
            (Places{"/opt/underact/share/underact/python", "/opt/underact/lib/python3/dist-packages"}));
  EXPECT_EQ(searchFolders("underact-guard", from),
            (Places{"/opt/underact/bin/underact-guard", "/opt/underact/libexec/underact/underact-guard"}));
}

TEST(Places, OfAProgramInABuildFolderAreTheSourcesWhereverItLies) {
  const SearchRoots from{.here = "/tmp/b/tests", .sources = "/home/t/underact", .programs = "/tmp/b"};
  EXPECT_EQ(searchFolders(Resource::Lessons, from).back(), "/home/t/underact/resources/lessons");
  EXPECT_EQ(searchFolders(Resource::Python, from).back(), "/home/t/underact/app/python");
  EXPECT_EQ(searchFolders("underact-guard", from).back(), "/tmp/b/underact-guard");
}

TEST(Places, WhatAPersonStatesComesFirstAsDataOrSources) {
  const SearchRoots from{.stated = "/data", .here = "/usr/bin"};
  EXPECT_EQ(searchFolders(Resource::Lessons, from),
            (Places{"/data/lessons", "/data/resources/lessons", "/usr/share/underact/lessons"}));
}

TEST(Places, AreNeverInTheFolderOneStandsIn) {
  const char* const before = std::getenv("UNDERACT_DATA_DIR");
  const std::string kept = before == nullptr ? "" : before;
  for (const char* stated : {"", ".", "data", "./data"}) {
    ::setenv("UNDERACT_DATA_DIR", stated, 1);
    for (const Resource resource : {Resource::Scenes, Resource::Lessons, Resource::Guide, Resource::Python}) {
      for (const std::string& place : searchFolders(resource, searchRoots())) EXPECT_EQ(place.front(), '/') << place;
    }
  }
  before == nullptr ? ::unsetenv("UNDERACT_DATA_DIR") : ::setenv("UNDERACT_DATA_DIR", kept.c_str(), 1);
  EXPECT_EQ(searchFolders(Resource::Scenes, {}), Places{});
}

TEST(Places, AreKnownForThisBuild) {
  const SearchRoots from = searchRoots();
  EXPECT_EQ(from.sources, UNDERACT_SOURCE);
  EXPECT_EQ(from.programs, UNDERACT_BINARY);
  for (const Resource resource : {Resource::Scenes, Resource::Lessons, Resource::Guide, Resource::Python})
    EXPECT_TRUE(findResource(resource, from));
}

TEST(FindResource, TakesTheFirstPlaceThatHoldsIt) {
  const Home home;
  fs::create_directories(home.at("data/scenes"));  // but nothing in it
  home.write("data/scenes/scene.schema.json");
  home.write("share/underact/scenes/01_point.json");
  EXPECT_EQ(findResource(Resource::Scenes, {.stated = home.at("data"), .here = home.at("bin")}).value(),
            home.at("share/underact/scenes"));
}

TEST(FindResource, SaysEachPlaceWhereItIsNot) {
  const Result<std::string> found =
      findResource(Resource::Lessons, {.stated = "/nowhere/data", .here = "/nowhere/bin", .sources = "/nowhere/src"});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.problems().front().sentence,
            "The lessons that come with Underact were not found in /nowhere/data/lessons, "
            "/nowhere/data/resources/lessons, /nowhere/share/underact/lessons, /nowhere/src/resources/lessons. "
            "Reinstall Underact, or set UNDERACT_DATA_DIR to its data folder (share/underact) or its source folder.");
}

TEST(FindProgram, TakesOneThatMayBeRun) {
  const Home home;
  home.write("bin/underact-guard");  // no program: nobody may run it
  home.write("libexec/underact/underact-guard", fs::perms::owner_exec);
  EXPECT_EQ(findProgram("underact-guard", nullptr, {.here = home.at("bin")}).value(),
            home.at("libexec/underact/underact-guard"));
}

TEST(FindProgram, SaysEachPlaceWhereItIsNot) {
  const Result<std::string> found =
      findProgram("underact-guard", nullptr, {.here = "/nowhere/bin", .programs = "/nowhere/build"});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.problems().front().sentence,
            "underact-guard was not found. Searched: /nowhere/bin/underact-guard, "
            "/nowhere/libexec/underact/underact-guard, /nowhere/build/underact-guard.");
}

}  // namespace
}  // namespace underact::system
