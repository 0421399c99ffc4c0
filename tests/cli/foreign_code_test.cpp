// A session may lie in a folder of strangers' files: none of them is run because one stands there.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

namespace fs = std::filesystem;

/// A folder with a session and files of a stranger, in which one stands; gone with the object.
class StrangersFolder {
 public:
  StrangersFolder() : path_(fs::temp_directory_path() / ("underact stranger " + std::to_string(::getpid()))) {
    fs::create_directories(path_);
    fs::copy_file(UNDERACT_TEST_DATA "/golden/session.h5", path_ / "a.h5");
  }
  ~StrangersFolder() { fs::remove_all(path_); }
  StrangersFolder(const StrangersFolder&) = delete;
  StrangersFolder& operator=(const StrangersFolder&) = delete;

  std::string at(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text, bool is_program = false) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
    if (is_program) fs::permissions(path_ / name, fs::perms::owner_exec, fs::perm_options::add);
  }
  /// A module that leaves a mark and ends Python.
  void writeModule(const std::string& name) const {
    write(name, "open('" + at("mark") + "', 'w')\nraise SystemExit(99)\n");
  }
  /// The program run there; surroundings: "NAME=VALUE ...".
  ProcessOutcome run(const std::string& words, const std::string& surroundings = "") const {
    return shell("cd '" + path_.string() + "' && env -u UNDERACT_DATA_DIR " + surroundings + " " + program() + " " +
                 words + " 2>&1");
  }
  ProcessOutcome plot(const std::string& surroundings = "") const {
    return run("log plot a.h5 --kind error --out e.png", surroundings);
  }
  bool wasRun() const { return fs::exists(path_ / "mark"); }

 private:
  fs::path path_;
};

class ForeignCode : public testing::Test {
 protected:
  void SetUp() override {
    if (shell("/usr/bin/python3 -c 'import h5py, matplotlib' 2>&1").exit != 0)
      GTEST_SKIP() << "SKIPPED: the system's Python has no h5py and matplotlib, so no plot was drawn.";
  }
  StrangersFolder folder_;
};

TEST_F(ForeignCode, ModulesBesideTheSessionAreNotImported) {
  for (const char* name : {"h5py", "numpy", "matplotlib", "underact", "json", "argparse", "os", "runpy", "importlib",
                           "encodings", "sitecustomize", "usercustomize"})
    folder_.writeModule(std::string(name) + ".py");
  const ProcessOutcome outcome = folder_.plot();
  EXPECT_EQ(outcome.exit, 0) << outcome.out;
  EXPECT_FALSE(folder_.wasRun());
  EXPECT_TRUE(fs::exists(folder_.at("e.png")));
  EXPECT_EQ(folder_.run("figures --out f --only 4.2").exit, 0);
  EXPECT_FALSE(folder_.wasRun());
}

TEST_F(ForeignCode, NorAreTheyWhereTheEnvironmentHasRelativeOrEmptyPlaces) {
  folder_.writeModule("h5py.py");
  folder_.writeModule("python/underact/__main__.py");
  folder_.writeModule("app/python/underact/__main__.py");
  folder_.writeModule("lib/python3/dist-packages/h5py.py");
  for (const char* surroundings : {"PYTHONPATH=", "PYTHONPATH=.", "PYTHONPATH=:/usr/lib",
                                   "UNDERACT_DATA_DIR=", "UNDERACT_DATA_DIR=.", "PYTHONUSERBASE=."}) {
    const ProcessOutcome outcome = folder_.plot(surroundings);
    EXPECT_EQ(outcome.exit, 0) << surroundings << ": " << outcome.out;
    EXPECT_FALSE(folder_.wasRun()) << surroundings;
  }
}

TEST_F(ForeignCode, SettingsOfMatplotlibBesideTheSessionAreNotRead) {
  folder_.write("matplotlibrc", "no.such.setting: 1\n");  // of which Matplotlib complains where it reads it
  const ProcessOutcome outcome = folder_.plot();
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_EQ(outcome.out.find("no.such.setting"), std::string::npos) << outcome.out;
  EXPECT_TRUE(fs::exists(folder_.at("e.png"))) << "the folder one stands in is still that of the names given";
}

TEST_F(ForeignCode, APythonInTheFolderIsNotTheOneOnThePath) {
  folder_.write("a-python", "#!/bin/sh\ntouch '" + folder_.at("mark") + "'\n", true);
  for (const char* path : {"", ":/usr/bin", "/usr/bin:", ".:/usr/bin", "/usr/bin::/bin", "."}) {
    const ProcessOutcome outcome = shell("cd '" + folder_.at("") + "' && UNDERACT_PYTHON=a-python PATH=" + path + " " +
                                         program() + " log plot a.h5 --kind error --out e.png 2>&1");
    EXPECT_EQ(outcome.exit, 4) << path << outcome.out;
    EXPECT_NE(outcome.out.find("Python could not be started (a-python)"), std::string::npos) << outcome.out;
    EXPECT_FALSE(folder_.wasRun()) << path;
  }
}

TEST_F(ForeignCode, APythonWithoutItsLibrariesIsToldWithTheWayOut) {
  folder_.write("bare-python", "#!/bin/sh\nexec /usr/bin/python3 -S \"$@\"\n", true);
  const ProcessOutcome outcome = folder_.plot("UNDERACT_PYTHON=./bare-python");  // named with its path: it is meant
  EXPECT_EQ(outcome.exit, 4);
  EXPECT_NE(outcome.out.find("Install python3-h5py, python3-matplotlib"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("Traceback"), std::string::npos) << outcome.out;
}

TEST(ForeignDriver, AVendorsLibraryInTheFolderIsNotLoaded) {
  const StrangersFolder folder;
  folder.write("libHD.so.3.4", "");  // where the loader takes it, it says that the file is too short
  const ProcessOutcome outcome = folder.run("devices", "-u UNDERACT_OPENHAPTICS");
  EXPECT_EQ(outcome.out.find("too short"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("vendor's driver"), std::string::npos) << outcome.out;
}

TEST_F(ForeignCode, WhatAPersonInstalledForThemselvesIsFound) {
  const std::string user = "PYTHONUSERBASE='" + folder_.at("user") + "'";
  std::string place =
      shell("env " + user + " /usr/bin/python3 -c 'import site; print(site.getusersitepackages(), end=\"\")'").out;
  ASSERT_TRUE(place.starts_with(folder_.at("user"))) << place;
  folder_.writeModule(fs::relative(place, folder_.at("")).string() + "/h5py.py");
  EXPECT_EQ(folder_.plot(user).exit, 99);
  EXPECT_TRUE(folder_.wasRun());
}

}  // namespace
}  // namespace underact::test
