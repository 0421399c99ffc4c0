#include "app/gui/window/features.h"

#include <gtest/gtest.h>

#include <set>

namespace underact::gui::test {

TEST(Features, EachBringsSomethingThatNoOtherHas) {
  std::set<QString> keys;
  for (const FeatureRow& row : features()) {
    EXPECT_TRUE(row.make != nullptr || !row.panels.empty());
    EXPECT_EQ(row.opens == nullptr, row.open_action == nullptr);
    for (const PanelRow& panel : row.panels) EXPECT_TRUE(keys.insert(panel.key).second) << panel.key;
  }
}

TEST(Features, AFileIsOpenedByTheFeatureWhoseItIs) {
  EXPECT_EQ(openerOf("hand.h5", features()), QString("replay.open"));
  EXPECT_EQ(openerOf("bunny.STL", features()), QString("mesh.add"));
  EXPECT_EQ(openerOf("path.csv", features()), QString("curve.add"));
  EXPECT_EQ(openerOf("nothing.json", features()), QString());  // a scene, right or wrong
  EXPECT_EQ(openerOf("hand.h5", {}), QString());
}

}  // namespace underact::gui::test
