#include <fstream>
#include <sstream>

#include "core/json/json.h"
#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

json::Value fileOf(const std::string& name) {
  const std::string path = std::string(UNDERACT_SOURCE) + "/resources/arms/" + name + ".json";
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  Result<json::Value> root = json::parse(text.str(), path);
  if (!root) {
    ADD_FAILURE() << describe(root.problems().front());
    return {};
  }
  return std::move(root).value();
}

double numberOf(const json::Value& row, const char* key) {
  return row.find(key)->number;
}

/// A pose of a file, whose lengths are mm.
Pose poseOf(const json::Value* rows) {
  Pose X = Pose::Identity();
  if (rows == nullptr) return X;
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      X.matrix()(i, j) = rows->items.at(static_cast<std::size_t>(i)).items.at(static_cast<std::size_t>(j)).number;
    }
  }
  X.translation() *= kMetrePerMillimetre;
  return X;
}

TEST(ArmResources, AreTheTablesThatAreTested) {
  for (const test::Arm& arm : {test::puma(), test::irb120()}) {
    const json::Value file = fileOf(arm.name);
    ASSERT_NE(file.find("dh"), nullptr) << arm.name;
    EXPECT_EQ(file.find("underact_arm")->number, 1.0);
    EXPECT_EQ(file.find("name")->text, arm.name);
    const std::vector<json::Value>& rows = file.find("dh")->items;
    ASSERT_EQ(rows.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      const DhRow read =
          test::row(numberOf(rows[i], "alpha_deg"), numberOf(rows[i], "a_mm"), numberOf(rows[i], "d_mm"),
                    numberOf(rows[i], "theta_deg"), numberOf(rows[i], "min_deg"), numberOf(rows[i], "max_deg"));
      const DhRow& tested = arm.rows[i];
      EXPECT_EQ(read.alpha_rad, tested.alpha_rad);
      EXPECT_EQ(read.a_m, tested.a_m);
      EXPECT_EQ(read.theta_rad, tested.theta_rad);
      EXPECT_EQ(read.d_m, tested.d_m);
      EXPECT_EQ(read.min, tested.min);
      EXPECT_EQ(read.max, tested.max);
    }
    EXPECT_EQ(poseOf(file.find("X_WB")).matrix(), arm.X_WB.matrix());
    EXPECT_EQ(poseOf(file.find("X_6T")).matrix(), arm.X_NT.matrix());
  }
}

}  // namespace
}  // namespace underact::chain
