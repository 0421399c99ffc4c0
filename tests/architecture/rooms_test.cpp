#include "tests/architecture/rooms.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <type_traits>

#include "core/safety/gate.h"

namespace underact::architecture {
namespace {

namespace fs = std::filesystem;

// What no text search can prove: nobody but its friend can make a force that is not zero.
static_assert(!std::is_constructible_v<safety::GatedForce, Vec3>);
static_assert(!std::is_convertible_v<Vec3, safety::GatedForce>);

/// A small source tree of its own, gone at the end.
class PlantedHouse : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("underact_architecture_" + std::to_string(getpid()));
    write("CMakeLists.txt",
          "underact_room(core/base SHOWS Eigen3::Eigen)  # underact_room(core/ghost)\n"
          "underact_room(core/system LINKS base)\n"
          "underact_room(core/safety LINKS base)\n"
          "underact_room(core/json LINKS base USES rapidjson)\n"
          "underact_room(core/scene LINKS json)\n"
          "underact_room(core/tick LINKS safety)\n"
          "underact_room(device LINKS tick)\n"
          "underact_room(app/gui/kit LINKS base SHOWS Qt6::Widgets)\n"
          "underact_room(app/gui/view LINKS gui/kit device SHOWS vtk LIKE gui/kit)\n"
          "underact_room(app/gui/feature LINKS gui/view LIKE gui/view)\n"
          "underact_feature(app/gui/feel)\n"
          "underact_feature(app/gui/lab LINKS scene)\n"
          "underact_room(app/gui/window LINKS ${UNDERACT_FEATURES} LIKE gui/view)\n"
          "underact_room(app/gui LINKS gui/window WITHOUT all)\n");
    write("core/tick/step.h",
          "#include \"core/base/types.h\"\n#include \"core/safety/gate.h\"\n#include <Eigen/Core>\n");
    write("core/safety/gate.h", "  friend Gated gate(const Limits&);\n");
    write("core/safety/gate.cpp", "return {GatedForce{f}, next};\n");
    write("device/arm.cpp", "#include \"core/tick/step.h\"\nport.write(safety::GatedForce{});\n");
    write("app/gui/main.cpp", "#include <QApplication>\n#include \"app/gui/lab/lab.h\"\n#include \"device/arm.h\"\n");
    write("app/gui/view/view.cpp", "#include <QWidget>\n#include <vtkActor.h>\n#include \"app/gui/kit/words.h\"\n");
    write("app/gui/lab/lab.cpp", "#include \"app/gui/view/view.h\"\n#include \"core/scene/read.h\"\n");
    write("app/gui/window/window.cpp", "#include \"app/gui/feel/feel.h\"\n");
  }
  void TearDown() override { fs::remove_all(root_); }
  void write(const std::string& path, const std::string& text) const {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }
  std::vector<std::string> found() const { return violations(root_); }
  void expectFound(const std::string& sentence) const { EXPECT_EQ(found(), std::vector<std::string>{sentence}); }

  fs::path root_;
};

TEST(House, EveryRoomIncludesOnlyWhatItMay) {
  for (const std::string& sentence : violations(UNDERACT_SOURCE)) ADD_FAILURE() << sentence;
}

TEST(House, EveryRoomOfTheWindowHasTestsOfItsOwn) {
  for (const std::string& sentence : withoutTests(UNDERACT_SOURCE)) ADD_FAILURE() << sentence;
}

TEST(House, TheRoomsOfTheRealHouseAreRead) {
  const Rooms rooms = roomsOf(textOf(fs::path(UNDERACT_SOURCE) / "CMakeLists.txt"));
  ASSERT_TRUE(rooms.contains("core/base"));
  ASSERT_TRUE(rooms.contains("app/cli"));
  EXPECT_TRUE(rooms.at("app/cli").contains("core/base"));  // by way of others
  EXPECT_FALSE(rooms.at("core/base").contains("core/tick"));
  EXPECT_GE(rooms.size(), 13U);
}

TEST(House, NoDriverIncludesTheCatalogueThatListsIt) {
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(fs::path(UNDERACT_SOURCE) / "device"))
    if (file.is_regular_file() && file.path().parent_path().filename() != "device") {
      EXPECT_EQ(textOf(file).find("\"device/catalogue.h\""), std::string::npos) << file.path();
    }
}

/// A row for the rooms of each level, indented: they link to rooms of the rows above only. The features are one row.
std::string drawingOf(const Rooms& rooms) {
  std::map<std::string, std::size_t> levels;
  const std::function<std::size_t(const std::string&)> levelOf = [&](const std::string& room) {
    if (const auto known = levels.find(room); known != levels.end()) return known->second;
    std::size_t level = 0;
    for (const std::string& other : rooms.at(room)) level = other == room ? level : std::max(level, levelOf(other) + 1);
    return levels[room] = level;
  };
  const std::size_t features = levelOf("app/gui/window") - 1;
  std::map<std::size_t, std::string> rows{{features, " the features of app/gui"}};
  for (const auto& [room, others] : rooms)
    if (levelOf(room) != features) rows[levelOf(room)] += " " + room;
  std::string drawing;
  for (const auto& [level, row] : rows) drawing += "   " + row + "\n";
  return drawing;
}

TEST(House, TheDrawingInContributingIsThatOfTheLinkLines) {
  const std::string drawing = drawingOf(roomsOf(textOf(fs::path(UNDERACT_SOURCE) / "CMakeLists.txt")));
  const std::string page = textOf(fs::path(UNDERACT_SOURCE) / "CONTRIBUTING.md");
  EXPECT_NE(page.find("\n\n" + drawing + "\n"), std::string::npos) << "it should be\n" << drawing;
}

TEST_F(PlantedHouse, ThatIsInOrderHasNoViolation) {
  EXPECT_EQ(found(), std::vector<std::string>{});
}

TEST_F(PlantedHouse, ARoomOfTheWindowWithoutATestIsFound) {
  for (const char* room : {"kit", "view", "feature", "feel", "window"})
    write("tests/gui/" + std::string(room) + "/some_test.cpp", "\n");
  write("tests/gui/lab/helper.cpp", "\n");  // is none
  EXPECT_EQ(withoutTests(root_), std::vector<std::string>{"app/gui/lab: has no test in tests/gui/lab"});
}

TEST_F(PlantedHouse, ALinkPointingDownIsFound) {
  write("core/base/types.h", "\n#include \"core/tick/step.h\"\n");
  expectFound("core/base/types.h:2: core/base may not use core/tick");
}

TEST_F(PlantedHouse, ANeighbourThatIsNotLinkedIsFound) {
  write("core/scene/read.cpp", "#include \"core/safety/gate.h\"\n");
  expectFound("core/scene/read.cpp:1: core/scene may not use core/safety");
}

TEST_F(PlantedHouse, AnAppInCoreIsFound) {
  write("core/tick/step.cpp", "#  include \"app/gui/window.h\"\n");
  expectFound("core/tick/step.cpp:1: core/tick may not use app/gui");
}

TEST_F(PlantedHouse, AFeatureThatUsesAnotherIsFound) {
  write("app/gui/lab/lab.cpp", "#include \"app/gui/feel/feel.h\"\n");
  expectFound("app/gui/lab/lab.cpp:1: app/gui/lab may not use app/gui/feel");
}

TEST_F(PlantedHouse, ARoomAboveItIsFoundInTheWindow) {
  write("app/gui/kit/words.cpp", "#include \"app/gui/view/view.h\"\n");  // compiled LIKE it is no link
  expectFound("app/gui/kit/words.cpp:1: app/gui/kit may not use app/gui/view");
}

TEST_F(PlantedHouse, WhatALinkOfOneFeatureBringsIsNotAnothers) {
  write("app/gui/feel/feel.cpp", "#include \"core/scene/read.h\"\n");
  expectFound("app/gui/feel/feel.cpp:1: app/gui/feel may not use core/scene");
}

TEST_F(PlantedHouse, TheServosHostInAFeatureIsFound) {
  write("app/gui/feel/feel.h", "  servo::Host& host_;\n");
  write("app/gui/window/window.h", "  servo::Host& host_;\n");
  expectFound("app/gui/feel/feel.h:1: nobody but the model has the servo's host: ServoFacts, ServoControl");
}

TEST_F(PlantedHouse, VtkInAFeatureIsFound) {
  write("app/gui/feel/feel.cpp", "#include <vtkActor.h>\n");
  expectFound("app/gui/feel/feel.cpp:1: VTK does not belong in app/gui/feel");
}

TEST_F(PlantedHouse, QtInADeviceIsFound) {
  write("device/mouse.h", "#include <QMouseEvent>\n");
  expectFound("device/mouse.h:1: Qt does not belong in device");
}

TEST_F(PlantedHouse, ANameOfQtsInCoreIsFoundAndWordsAboutItAreNot) {
  write("core/tick/step.cpp", "f(\"QT_PLUGIN_PATH\");  // as Qt's QString\ng(QT_TRANSLATE_NOOP(\"a\", \"b\"));\n");
  write("device/arm.cpp", "str(1);\nf(tr(\"No.\"));\n");
  EXPECT_EQ(found(), (std::vector<std::string>{"core/tick/step.cpp:2: QT_TRANSLATE_NOOP is a name of Qt's",
                                               "device/arm.cpp:2: tr is a name of Qt's"}));
}

TEST_F(PlantedHouse, VtkInCoreIsFound) {
  write("core/tick/draw.cpp", "#include <vtkSphereSource.h>\n");
  expectFound("core/tick/draw.cpp:1: VTK does not belong in core/tick");
}

TEST_F(PlantedHouse, MpiInCoreIsFound) {
  write("core/tick/team.cpp", "#include <mpi.h>\n");
  expectFound("core/tick/team.cpp:1: MPI does not belong in core/tick");
}

TEST_F(PlantedHouse, AHeaderOfTheOperatingSystemIsFoundAndInItsRoomsSourceIsNot) {
  write("core/system/file_linux.cpp", "#include <sys/stat.h>\n#include <csignal>\n");
  write("device/arm.h", "#include <cerrno>\n#include <xmmintrin.h>\n#include <hidapi/hidapi.h>\n");
  write("device/arm.cpp", "#include <cstdio>\n#include <hidapi/hidapi.h>\n#include <fcntl.h>\n");
  write("app/gui/main.cpp", "#include <QWidget>\n#include <csignal>\n");
  write("core/system/file.h", "#include <windows.h>\n");
  EXPECT_EQ(found(), (std::vector<std::string>{
                         "app/gui/main.cpp:2: the operating system does not belong in app/gui",
                         "core/system/file.h:1: the operating system may not show in a header",
                         "device/arm.cpp:3: the operating system does not belong in device",
                         "device/arm.h:3: hidapi may not show in a header",
                     }));
}

TEST_F(PlantedHouse, RapidJsonInAHeaderIsFoundAndInItsRoomsSourceIsNot) {
  write("core/json/json.cpp", "#include <rapidjson/reader.h>\n");
  write("core/json/json.h", "#include <rapidjson/reader.h>\n");
  expectFound("core/json/json.h:1: RapidJSON may not show in a header");
}

TEST_F(PlantedHouse, AForceMadeOutsideTheGateIsFound) {
  write("device/arm.cpp", "port.write(safety::GatedForce{f_T_W});\n");
  expectFound("device/arm.cpp:1: only the gate makes a GatedForce");
}

TEST_F(PlantedHouse, AForgedForceIsFound) {
  write("device/arm.cpp", "port.write(*reinterpret_cast<const safety::GatedForce*>(&f_T_W));\n");
  expectFound("device/arm.cpp:1: only the gate makes a GatedForce");
}

TEST_F(PlantedHouse, ASecondFriendOfTheGateIsFound) {
  write("core/safety/gate.h", "  friend Gated gate(const Limits&);\n  friend class Backdoor;\n");
  expectFound("core/safety/gate.h:2: GatedForce has gate() for its only friend");
}

TEST_F(PlantedHouse, AFileThatLiesInNoRoomIsFound) {
  write("core/attic/old.cpp", "\n");
  expectFound("core/attic/old.cpp: lies in no room");
}

}  // namespace
}  // namespace underact::architecture
