#include "app/gui/window/features.h"

#include <gtest/gtest.h>

#include <set>

namespace underact::gui::test {

TEST(Features, EachBringsSomethingThatNoOtherHas) {
  std::set<QString> keys;
  for (const FeatureRow& row : features()) {
    EXPECT_TRUE(row.make != nullptr || !row.panels.empty());
    EXPECT_EQ(row.opens == FileKind::Scene, row.open_action == nullptr);
    for (const PanelRow& panel : row.panels) EXPECT_TRUE(keys.insert(panel.key).second) << panel.key;
  }
}

TEST(Features, AFileOfEachKindIsOpenedByTheFeatureWhoseItIs) {
  EXPECT_EQ(openerOf(FileKind::Scene, features()), QString()) << "the window itself opens scenes";
  for (int kind = 1; kind <= static_cast<int>(FileKind::Notebook); ++kind)
    EXPECT_FALSE(openerOf(static_cast<FileKind>(kind), features()).isEmpty()) << kind;
  EXPECT_EQ(openerOf(FileKind::Session, {}), QString());
}

}  // namespace underact::gui::test
