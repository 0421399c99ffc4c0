// Solids of arm files: read, written in each form, and refused with their lines.
#include "core/arm/arm_text.h"
#include "core/arm/model.h"
#include "core/arm/urdf.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

std::string armWithSolids(const std::string& solids) {
  return R"({"underact_arm": 1, "name": "a", "title": "t", "provenance": "p",
    "joints": [{"axis": [0, 0, 1], "point_mm": [0, 0, 0]}, {"axis": [0, 1, 0], "point_mm": [100, 0, 50]}],
    "X_WT_home": [[1, 0, 0, 200], [0, 1, 0, 0], [0, 0, 1, 50], [0, 0, 0, 1]],
    "solids": [)" +
         solids + "]}";
}

constexpr const char* kOfEach = R"(
  {"link": 0, "type": "box", "size_mm": [80, 60, 20], "X_WS": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -10], [0, 0, 0, 1]]},
  {"link": 1, "type": "cylinder", "radius_mm": 12, "length_mm": 100,
   "X_WS": [[0, 0, 1, 50], [0, 1, 0, 0], [-1, 0, 0, 50], [0, 0, 0, 1]]},
  {"link": 2, "type": "sphere", "radius_mm": 15}%)";

std::string ofEach(const std::string& more = "") {
  std::string text = kOfEach;
  return text.substr(0, text.size() - 1) + more;
}

void expectSameSolids(const std::vector<LinkSolid>& got, const std::vector<LinkSolid>& wanted, const char* form) {
  ASSERT_EQ(got.size(), wanted.size()) << form;
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].link, wanted[i].link) << form;
    EXPECT_EQ(got[i].form.index(), wanted[i].form.index()) << form;
    EXPECT_LT((got[i].X_WS.matrix() - wanted[i].X_WS.matrix()).norm(), 1e-12) << form;
  }
}

/// The first sentence about such a file, and its key.
std::string solidProblem(const std::string& solids) {
  const Result<Model> model = readArm(armWithSolids(solids), "a.json");
  return model ? "" : model.problems()[0].sentence + " @" + model.problems()[0].place.key;
}

}  // namespace

TEST(Solids, AreReadInMetres) {
  const Model model =
      readArm(armWithSolids(ofEach(R"(, {"link": 2, "type": "capsule", "radius_mm": 5, "length_mm": 40})")), "a.json")
          .value();
  ASSERT_EQ(model.solids.size(), 4U);
  EXPECT_EQ(std::get<BoxSolid>(model.solids[0].form).size_m, Vec3(0.08, 0.06, 0.02));
  EXPECT_EQ(model.solids[0].X_WS.translation(), Vec3(0.0, 0.0, -0.01));
  EXPECT_EQ(std::get<CylinderSolid>(model.solids[1].form).length_m, 0.1);
  EXPECT_EQ(std::get<SphereSolid>(model.solids[2].form).radius_m, 0.015);
  EXPECT_EQ(std::get<CapsuleSolid>(model.solids[3].form).radius_m, 0.005);
  EXPECT_EQ(model.solids[3].link, 2U);
}

TEST(Solids, ComeBackInEveryForm) {
  const Model model = readArm(armWithSolids(ofEach()), "a.json").value();
  expectSameSolids(readArm(textOf(model, ArmForm::Exponentials).value(), "b.json").value().solids, model.solids, "poe");
  expectSameSolids(readArm(textOf(model, ArmForm::ModifiedDh).value(), "b.json").value().solids, model.solids, "dh");
  expectSameSolids(readUrdf(textOf(model, ArmForm::Urdf).value(), "b.urdf", {}).value().solids, model.solids, "urdf");
}

TEST(Solids, ThatNoArmHasAreErrorsAtTheirKeys) {
  EXPECT_NE(solidProblem(R"({"link": 3, "type": "sphere", "radius_mm": 1})").find("@solids[0].link"),
            std::string::npos);
  EXPECT_NE(solidProblem(R"({"link": 0.5, "type": "sphere", "radius_mm": 1})").find("whole number"), std::string::npos);
  EXPECT_NE(solidProblem(R"({"link": 1, "type": "sphere", "radius_mm": 0})").find("above 0"), std::string::npos);
  EXPECT_NE(solidProblem(R"({"link": 1, "type": "box", "size_mm": [1, -1, 1]})").find("above 0"), std::string::npos);
  EXPECT_NE(solidProblem(R"({"link": 1, "type": "cone", "radius_mm": 1})").find("@solids[0].type"), std::string::npos);
  EXPECT_NE(solidProblem(R"({"link": 1, "type": "cylinder", "radius_mm": 1})").find("length_mm"), std::string::npos);
  EXPECT_NE(solidProblem(R"({"link": 1, "type": "sphere", "radius_mm": 1, "colour": 3})").find("colour"),
            std::string::npos);
  std::string many = R"({"link": 0, "type": "sphere", "radius_mm": 1})";
  for (std::size_t i = 0; i < kMaxSolids; ++i) many += R"(, {"link": 0, "type": "sphere", "radius_mm": 1})";
  EXPECT_NE(solidProblem(many).find("at most 256"), std::string::npos);
}

TEST(Solids, OfUrdfAreItsFormsAndWhatCannotBeDrawnIsNoted) {
  const auto robot = [](const std::string& picture) {
    return R"(<robot name="r"><link name="a"/><link name="b"><visual><origin xyz="0 0 0.1"/><geometry>)" + picture +
           R"(</geometry></visual><visual><geometry><sphere radius="0.02"/></geometry></visual></link>
      <joint name="j" type="continuous"><parent link="a"/><child link="b"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/></joint>
      </robot>)";
  };
  const Model model = readUrdf(robot(R"(<box size="0.1 0.2 0.3"/>)"), "r.urdf", {}).value();
  ASSERT_EQ(model.solids.size(), 2U);
  EXPECT_EQ(model.solids[0].link, 1U);
  EXPECT_EQ(model.solids[0].X_WS.translation(), Vec3(1.0, 0.0, 0.1));
  const Model round = readUrdf(robot(R"(<capsule radius="1" length="2"/>)"), "r.urdf", {}).value();
  ASSERT_EQ(round.solids.size(), 2U);
  EXPECT_EQ(std::get<CapsuleSolid>(round.solids[0].form).length_m, 2.0);
  EXPECT_TRUE(round.notes.empty());
  for (const char* form :
       {R"(<box size="0.1 0 0.3"/>)", R"(<cone radius="1"/>)", R"(<cylinder radius="x" length="1"/>)",
        R"(<mesh filename="m.stl" scale="0 1 1"/>)", "<box/>"}) {
    const Result<Model> rest = readUrdf(robot(form), "r.urdf", {});
    ASSERT_TRUE(rest) << form;
    EXPECT_EQ(rest.value().solids.size(), 1U) << form;
    ASSERT_EQ(rest.value().notes.size(), 1U) << form;
    EXPECT_EQ(rest.value().notes[0].place.line, 1);
    EXPECT_TRUE(rest.value().notes[0].sentence.find("A picture of link \"b\" is not drawn: ") == 0) << form;
  }
}

TEST(Solids, ACapsuleIsNoFormOfUrdf) {
  const Model model =
      readArm(armWithSolids(R"({"link": 1, "type": "capsule", "radius_mm": 5, "length_mm": 40})"), "a.json").value();
  EXPECT_NE(textOf(model, ArmForm::Urdf).problems()[0].sentence.find("capsule"), std::string::npos);
}

}  // namespace underact::arm
