#include "device/column_major.h"

#include "core/arm/forward.h"
#include "tests/core/arm/golden.h"

namespace underact::device {

TEST(ColumnMajor, MeetsTheGoldenTransformsBothWays) {
  const test::Value file = test::golden("fk.json");
  for (const test::Value& one : file.find("cases")->items) {
    ColumnMajor T_mm{};
    for (std::size_t entry = 0; entry < T_mm.size(); ++entry) {
      T_mm[entry] = one.find("T_hd_colmajor")->items.at(entry).number;
    }
    const Pose X_WT = test::poseOf(*one.find("T"));
    ASSERT_EQ(poseFrom(T_mm).matrix(), X_WT.matrix()) << "line " << one.line;
    const ColumnMajor again_mm = columnMajorFrom(X_WT);
    for (std::size_t entry = 0; entry < T_mm.size(); ++entry) {
      ASSERT_NEAR(again_mm[entry], T_mm[entry], 1e-12) << "line " << one.line;  // mm to m and back: two roundings
    }
    const arm::Geometry& geometry = arm::findPreset("omni-thesis")->geometry;
    const Pose computed = arm::tipPose(geometry, test::anglesOf(*one.find("q")));
    ASSERT_LE((computed.matrix() - poseFrom(T_mm).matrix()).cwiseAbs().maxCoeff(), 1e-13);
  }
}

}  // namespace underact::device
