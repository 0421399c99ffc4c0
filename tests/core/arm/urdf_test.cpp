#include "core/arm/urdf.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/units.h"
#include "core/chain/kinematics.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

/// A robot of a base, a turntable, a boom that slides, and two fingers that are fixed to it.
std::string robotWith(const std::string& joint_2, const std::string& more = "") {
  return R"(<?xml version="1.0"?>
<robot name="crane">
  <link name="base"/>
  <link name="table"><inertial><mass value="2"/><origin xyz="0.1 0 0"/><inertia ixx="1" iyy="2" izz="3"/></inertial></link>
  <link name="boom"/>
  <link name="left"><inertial><mass value="1"/></inertial></link>
  <link name="right"/>
  <joint name="turn" type="continuous"><parent link="base"/><child link="table"/>
    <origin xyz="0 0 0.5" rpy="0 0 0"/><axis xyz="0 0 1"/></joint>
  )" + joint_2 +
         R"(
  <joint name="l" type="fixed"><parent link="boom"/><child link="left"/><origin xyz="0.2 0.1 0" rpy="0 0 1.5707963267948966"/></joint>
  <joint name="r" type="fixed"><parent link="boom"/><child link="right"/><origin xyz="0.2 -0.1 0"/></joint>
  )" + more +
         "</robot>\n";
}
const std::string kSlide = R"(<joint name="reach" type="prismatic"><parent link="table"/><child link="boom"/>
    <axis xyz="1 0 0"/><limit lower="0" upper="0.3" effort="1" velocity="1"/></joint>)";

std::string toldOf(const std::string& text, const UrdfEnds& ends = {"base", "left"}) {
  const Result<Model> read = readUrdf(text, "a.urdf", ends);
  std::string all;
  if (read) return all;
  for (const Problem& one : read.problems())
    all += std::to_string(one.place.line) + " " + one.place.key + ": " + one.sentence + "\n";
  return all;
}

TEST(Urdf, ByHand) {
  const Result<Model> read = readUrdf(robotWith(kSlide), "a.urdf", {"base", "left"});
  ASSERT_TRUE(read) << toldOf(robotWith(kSlide));
  const Model& crane = read.value();
  ASSERT_EQ(crane.joints.size(), 2U);
  EXPECT_EQ(crane.joints[1].name, "reach");
  EXPECT_DOUBLE_EQ(crane.rows[1].max, 0.3);
  EXPECT_EQ(crane.rows[0].max, kInfinity);
  const std::array<double, 2> q{kPi / 2, 0.1};
  const Pose X = chain::forward(crane.chain, q);
  EXPECT_LE((X.translation() - Vec3(-0.1, 0.3, 0.5)).norm(), 1e-15);
  EXPECT_LE((X.linear() * Vec3::UnitX() - Vec3(-1, 0, 0)).norm(), 1e-15);
  ASSERT_EQ(crane.masses.size(), 2U);
  EXPECT_EQ(crane.masses[0].mass_kg, 2.0);
  EXPECT_LE((crane.masses[0].p_WC - Vec3(0.1, 0, 0.5)).norm(), 1e-15);
  EXPECT_EQ(crane.masses[1].mass_kg, 1.0);  // the finger that is fixed to the boom
  EXPECT_LE((crane.masses[1].p_WC - Vec3(0.2, 0.1, 0.5)).norm(), 1e-15);
}

TEST(Urdf, UpAndDownAgain) {  // from one finger to the base: the inverse of the way there
  const Result<Model> there = readUrdf(robotWith(kSlide), "a.urdf", {"base", "left"});
  const Result<Model> back = readUrdf(robotWith(kSlide), "a.urdf", {"left", "base"});
  ASSERT_TRUE(there && back);
  const std::array<double, 2> q{0.7, 0.2}, reversed{0.2, 0.7};
  const Pose both = chain::forward(there.value().chain, q) * chain::forward(back.value().chain, reversed);
  EXPECT_LE((both.matrix() - Eigen::Matrix4d::Identity()).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_NE(
      toldOf(robotWith(kSlide), {"left", "right"}).find("No joint between link \"left\" and link \"right\" moves"),
      std::string::npos);
}

TEST(Urdf, NamesWhatIsWrongWithItsLineAndTheNearestWord) {
  EXPECT_EQ(toldOf(robotWith(kSlide)), "");
  EXPECT_EQ(toldOf(robotWith(kSlide), {"bse", "left"}), "0 base: There is no link \"bse\". Did you mean \"base\"?\n");
  const auto joint = [](const std::string& type, const std::string& inside) {
    return robotWith("<joint name=\"reach\" type=\"" + type + "\"><parent link=\"table\"/><child link=\"boom\"/>\n" +
                     inside + "</joint>");
  };
  const std::string limit = "<limit lower=\"0\" upper=\"1\"/>";
  EXPECT_EQ(toldOf(joint("prismatc", limit)),
            "10 type: The type \"prismatc\" is not known. Did you mean \"prismatic\"?\n");
  EXPECT_NE(toldOf(joint("revolute", "")).find("10 limit: The element <limit> is missing"), std::string::npos);
  EXPECT_NE(toldOf(joint("revolute", "<limit lower=\"1\" upper=\"1\"/>")).find("11 lower: The joint's lower limit"),
            std::string::npos);
  EXPECT_EQ(toldOf(robotWith(kSlide, R"(<link name="wheel"/><joint name="w" type="revolute"><parent link="base"/>
                                        <child link="wheel"/><limit effort="1" velocity="1"/></joint>)")),
            "");  // beside the way
  EXPECT_EQ(toldOf(joint("revolute", limit + "<orgin xyz=\"0 0 0\"/>")),
            "11 orgin: The element \"orgin\" is not known here. Did you mean \"origin\"?\n");
  EXPECT_NE(toldOf(joint("revolute", "<limit lowr=\"1\" upper=\"2\"/>")).find("11 lowr: The attribute \"lowr\""),
            std::string::npos);
  EXPECT_NE(toldOf(joint("revolute", limit + "<axis xyz=\"0 0 0\"/>")).find("11 xyz: The axis has no direction."),
            std::string::npos);
  for (const char* numbers : {"1 2", "1 2 3 4", "1 2 x", "1 2 nan", "1 2 inf", "1,2,3", "1 2 1e999", ""}) {
    EXPECT_NE(toldOf(joint("revolute", limit + "<origin xyz=\"" + numbers + "\"/>"))
                  .find("11 xyz: This must be 3 finite numbers"),
              std::string::npos)
        << numbers;
  }
  EXPECT_NE(toldOf(joint("planar", "")).find("10 type: The joint \"reach\" is \"planar\""), std::string::npos);
  EXPECT_NE(toldOf(joint("revolute", limit + "<mimic joint=\"turn\"/>")).find("10 mimic: "), std::string::npos);
  EXPECT_NE(toldOf(robotWith(kSlide, "<link name=\"left\"/>")).find("The name \"left\" appears twice"),
            std::string::npos);
  EXPECT_NE(toldOf(robotWith(kSlide,
                             "<joint name=\"x\" type=\"fixed\"><parent link=\"base\"/><child link=\"left\"/></joint>"))
                .find("two parents"),
            std::string::npos);
  EXPECT_NE(toldOf(robotWith(kSlide,
                             "<joint name=\"x\" type=\"fixed\"><parent link=\"left\"/><child link=\"base\"/></joint>"),
                   {"", "right"})
                .find("no link that could be its base"),
            std::string::npos);
}

TEST(Urdf, ReadsNoForeignFilesAndNoDeepOnes) {
  const std::string body = "<robot name=\"r\"><link name=\"&x;\"/></robot>";
  EXPECT_NE(toldOf("<!DOCTYPE robot [<!ENTITY x SYSTEM \"file:///etc/passwd\">]>\n" + body)
                .find("1 : A document type is not allowed"),
            std::string::npos);
  std::string deep;
  for (int level = 0; level < 5000; ++level) deep += "<a>";
  EXPECT_NE(toldOf(deep).find("nested more than 100 levels"), std::string::npos);
  for (const char* text : {"", " ", "<", "<robot>", "<robot name='r'", "<x/>", "<robot name='r'/>", "{}", "\xff\xfe"}) {
    EXPECT_NE(toldOf(text), "") << text;
  }
  EXPECT_NE(toldOf(std::string("<robot\0/>", 9)).find("zero bytes"), std::string::npos);
  EXPECT_NE(toldOf("<robot name=\"r\"><xacro:macro/></robot>").find("macro (xacro)"), std::string::npos);
}

TEST(Urdf, HasAtMostEightJointsOnTheWay) {
  std::string text = "<robot name=\"r\"><link name=\"l0\"/>";
  for (int i = 1; i <= 9; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    text += "<link name=\"l" + n + "\"/><joint name=\"j" + n + "\" type=\"continuous\"><parent link=\"l" + before +
            "\"/><child link=\"l" + n + "\"/></joint>";
  }
  text += "</robot>";
  EXPECT_NE(toldOf(text, {"l0", "l9"}).find("this is the ninth"), std::string::npos);
  EXPECT_EQ(toldOf(text, {"l0", "l8"}), "");
}

TEST(Urdf, AnElementOfMoreThan64AttributesIsRefusedAndOthersAreRead) {
  const auto with = [](int count) {
    std::string link = "<link name=\"more\"";
    for (int i = 1; i < count; ++i) link += (i % 2 == 0 ? "\n a" : " a") + std::to_string(i) + " = '>\"<a b=\"\"'";
    const std::string text = robotWith(kSlide, "<!-- <a b=''> -->\n<![CDATA[ <e f=\"> ]]>\n" + link + "/>");
    return toldOf(text);
  };
  EXPECT_EQ(with(64), "");
  EXPECT_EQ(with(65), "16 : An element can have at most 64 attributes.\n");
  EXPECT_EQ(with(20'000), "16 : An element can have at most 64 attributes.\n");
}

TEST(Urdf, AReferenceWithoutAnEndIsRefusedInAValueAlone) {
  const auto with = [](const std::string& more) { return toldOf(robotWith(kSlide, more)); };
  EXPECT_EQ(with("<link name=\"&#65;&#x0010FFFF;&amp;&\"/> &#1 <!-- &#1 -->"), "");
  EXPECT_EQ(with("<a b=\"\n&#65&#66&#67 &#68\"/>"), "15 : A reference such as &#65; ends with a semicolon.\n");
}

TEST(Urdf, OfManyJointsWithTwoParentsOnly100AreNamed) {
  std::string more;
  for (int i = 0; i < 300; ++i)
    more += "<joint name=\"m" + std::to_string(i) +
            "\" type=\"fixed\"><parent link=\"base\"/><child link=\"left\"/></joint>";
  const std::string told = toldOf(robotWith(kSlide, more));
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 100);
}

/// A robot of links in a row; each joint of "r" turns, of "f" is fixed, of "m" follows, of "p" is planar; more: further
/// elements.
std::string row(const std::string& joints, const std::string& more = "") {
  std::string text = "<robot name=\"r\"><link name=\"l0\"/>";
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string n = std::to_string(i + 1), type = joints[i] == 'f'   ? "fixed"
                                                        : joints[i] == 'p' ? "planar"
                                                                           : "continuous";
    text += "\n<link name=\"l" + n + "\"><inertial><mass value=\"1\"/></inertial></link><joint name=\"j" + n +
            "\" type=\"" + type + "\"><parent link=\"l" + std::to_string(i) + "\"/><child link=\"l" + n + "\"/>" +
            (joints[i] == 'm' ? "<mimic joint=\"j1\"/>" : "") + "</joint>";
  }
  return text + more + "</robot>";
}
std::string hung(const std::string& parent, const std::string& name, const std::string& type) {
  return "\n<link name=\"" + name + "\"><inertial><mass value=\"2\"/></inertial></link><joint name=\"to " + name +
         "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + name + "\"/></joint>";
}
/// The tip that is chosen, and "!" behind it where that is said.
std::string tipOf(const std::string& text, const UrdfEnds& ends = {}) {
  const Result<Model> read = readUrdf(text, "a.urdf", ends);
  if (!read) return toldOf(text, ends);
  const std::string& told = read.value().provenance;
  const std::size_t from = told.rfind("to link ") + 8;
  const bool noted = std::any_of(read.value().notes.begin(), read.value().notes.end(), [](const Problem& note) {
    return note.sentence.find("is taken as the tip") != std::string::npos;
  });
  return told.substr(from, told.size() - from - 1) + (noted ? "!" : "");
}

TEST(UrdfTip, IsTheEndOfTheArmWhereSeveralLinksCouldBe) {
  EXPECT_EQ(tipOf(row("rr")), "l2");
  EXPECT_EQ(tipOf(row("rr", hung("l0", "stand", "fixed"))), "l2!");  // what no joint moves is no tip
  EXPECT_EQ(tipOf(row("rr", hung("l2", "tool0", "fixed") + hung("l2", "camera", "fixed"))), "tool0!");
  EXPECT_EQ(tipOf(row("rrf", hung("l2", "camera", "fixed"))), "l3!");  // in the order of the file
  EXPECT_EQ(tipOf(row("rrr", hung("l3", "left", "continuous") + hung("l3", "right", "continuous"))).substr(0, 2), "l3");
  EXPECT_EQ(tipOf(row("rrrf", hung("l4", "left", "continuous") + hung("l4", "right", "continuous"))), "l4!");
  EXPECT_EQ(tipOf(row("rrrf", hung("l3", "left", "continuous") + hung("l3", "right", "continuous"))), "l3!");
  EXPECT_EQ(tipOf(row("rrrrrr", hung("l3", "rod", "continuous"))), "l6!");  // a rod beside the arm is no finger
  EXPECT_EQ(tipOf(row("rrr", hung("l0", "wheel", "continuous"))), "l3!");   // the way with the most joints
  EXPECT_EQ(tipOf(row("prr", hung("l2", "lamp", "fixed"))), "l3!");         // from behind the floating base
  EXPECT_EQ(tipOf(row("rr", hung("l2", "a", "fixed") + hung("l2", "b", "fixed")), {"", "b"}), "b");
}

TEST(UrdfTip, EachRefusalSaysWhatToDo) {
  EXPECT_NE(tipOf(row("rrm"))
                .find("4 mimic: The joint \"j3\" follows another one; each joint of an arm moves by itself. "
                      "Leave it out (arm convert --tip l2)."),
            std::string::npos);
  EXPECT_EQ(tipOf(row("rrm"), {"", "l2"}), "l2");
  EXPECT_NE(tipOf(row("mrr")).find("(arm convert --base l1)"), std::string::npos);
  EXPECT_NE(tipOf(row("rrpr")).find("4 type: "), std::string::npos);
  EXPECT_NE(tipOf(row("rrrrrrrrr")).find("this is the ninth. End it before (arm convert --tip l8)."),
            std::string::npos);
  EXPECT_NE(tipOf(row("ff")).find("No joint between link \"l0\" and link \"l2\" moves."), std::string::npos);
}

TEST(UrdfMasses, AreThoseOfAllThatAJointCarries) {
  const Model model = readUrdf(row("rf", hung("l1", "camera", "fixed") + hung("l2", "wheel", "continuous") +
                                             hung("l0", "stand", "fixed")),
                               "a.urdf", {"l0", "l2"})
                          .value();
  ASSERT_EQ(model.masses.size(), 1U);
  EXPECT_EQ(model.masses[0].mass_kg, 4.0);  // l1, l2 and the camera; not the wheel, nor what stands
  ASSERT_EQ(model.notes.size(), 1U);
  EXPECT_EQ(model.notes[0].sentence,
            "2 kg on joints beside the arm, from link \"wheel\" on, are in none of its masses.");
  // Upwards the joint carries what was below: l0, and what is fixed to it.
  const Model back = readUrdf(row("rf", hung("l0", "stand", "fixed")), "a.urdf", {"l2", "l0"}).value();
  EXPECT_EQ(back.masses[0].mass_kg, 2.0);
}

TEST(Urdf, AQuaternionTurnsALinkAsRollPitchAndYawDo) {
  const auto with = [](const std::string& origin) {
    return "<robot name=\"r\" version=\"1.1\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" "
           "type=\"continuous\">"
           "<parent link=\"a\"/><child link=\"b\"/>\n<origin " +
           origin + "/></joint></robot>";
  };
  const Pose X = readUrdf(with("quat_xyzw=\"0 0.70710678 0 0.70710678\""), "a.urdf", {}).value().chain.X_WT_home;
  const Pose wanted = readUrdf(with("rpy=\"0 1.5707963267948966 0\""), "a.urdf", {}).value().chain.X_WT_home;
  EXPECT_LE((X.matrix() - wanted.matrix()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NE(
      toldOf(with("quat_xyzw=\"0 0 0 2\""), {}).find("2 quat_xyzw: A quaternion must have the length 1; here it is 2."),
      std::string::npos);
  EXPECT_NE(toldOf(with("quat_xyzw=\"0 0 1\""), {}).find("4 finite numbers"), std::string::npos);
  EXPECT_NE(toldOf(with("quat_xyzw=\"0 0 0 1\" rpy=\"0 0 1\""), {}).find("not both"), std::string::npos);
  EXPECT_NE(toldOf(with("matrix=\"1 0 0\""), {}).find("2 matrix: The attribute \"matrix\" is not known in <origin>"),
            std::string::npos);
  EXPECT_EQ(toldOf(with("xyz=\"0 0 0\" my:note=\"x\""), {}), "");
}

TEST(Urdf, RefusesUnknownElementsThatMayMoveALinkWithTheirLine) {
  const auto versioned = [](const std::string& version) {
    return "<robot name=\"r\" version=\"" + version +
           "\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" "
           "type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/></joint></robot>";
  };
  for (const char* version : {"1", "1.0", "1.1", "1.2"}) EXPECT_EQ(toldOf(versioned(version), {}), "") << version;
  EXPECT_NE(toldOf(versioned("2.0"), {}).find("1 version: This program reads URDF of the versions 1.0, 1.1 and 1.2"),
            std::string::npos);
  const auto joint = [](const std::string& inside) {
    return robotWith("<joint name=\"reach\" type=\"revolute\"><parent link=\"table\"/><child link=\"boom\"/>\n" +
                     inside + "<limit lower=\"0\" upper=\"1\"/></joint>");
  };
  EXPECT_NE(toldOf(joint("<origin xyz=\"0 0 1\"/><origin xyz=\"0 0 2\"/>"))
                .find("11 origin: The element <origin> appears twice in <joint>."),
            std::string::npos);
  EXPECT_NE(toldOf(joint("<axis xyz=\"0 0 1\" frame=\"world\"/>")).find("11 frame: The attribute"), std::string::npos);
  EXPECT_NE(toldOf(joint("<origin><rotation>1</rotation></origin>")).find("11 rotation: The element"),
            std::string::npos);
}

TEST(Urdf, ALimitWithoutARangeIsNoneAndNoted) {
  for (const char* limit : {"<limit effort=\"1\" velocity=\"1\"/>", "<limit lower=\"0\" upper=\"0\"/>"}) {
    const Result<Model> read =
        readUrdf(robotWith(std::string("<joint name=\"reach\" type=\"revolute\"><parent link=\"table\"/>"
                                       "<child link=\"boom\"/>\n") +
                           limit + "</joint>"),
                 "a.urdf", {"base", "left"});
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().rows[1].max, kInfinity);
    ASSERT_EQ(read.value().notes.size(), 1U);
    EXPECT_EQ(read.value().notes[0].place.line, 11);
  }
}

TEST(ArmFiles, AreReadAsWhatTheyContain) {
  for (const char* name : {"a.urdf", "A.URDF", "a.XML", "a.txt", "a.xacro", "a.json"}) {
    const Result<Model> read = readArmText("\xEF\xBB\xBF\n" + row("rr"), name);
    ASSERT_TRUE(read) << name;
    EXPECT_EQ(read.value().form, ArmForm::Urdf);
    EXPECT_FALSE(readArmText("{}", name));
  }
  EXPECT_NE(readArmText("{}", "a.urdf", {"a", ""}).problems()[0].sentence.find("--base and --tip"), std::string::npos);
}

TEST(Urdf, LargeFilesAreRefused) {
  const std::string path = testing::TempDir() + "large.urdf";
  std::ofstream(path) << "<robot name=\"r\"><!--" << std::string(std::size_t{4} << 20, '-') << "--></robot>";
  const Result<Model> read = readArmFile(path);
  ASSERT_FALSE(read);
  EXPECT_NE(read.problems().front().sentence.find("larger than 4 MiB"), std::string::npos)
      << read.problems().front().sentence;
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace underact::arm
