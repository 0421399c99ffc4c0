#include "app/gui/view/path_picture.h"

#include <gtest/gtest.h>

namespace underact::gui::test {

TEST(PathPicture, APathIsBrokenWhereAPlaceIsNoNumberAndHiddenWithItsLayer) {
  PathPicture picture;
  std::vector<PathPoint> path(6);
  for (std::size_t index = 0; index < path.size(); ++index) path[index].p_mm.x() = static_cast<double>(index);
  path[2].p_mm.y() = kNotANumber;
  picture.setPath(path);
  EXPECT_EQ(picture.parts(), 3U);
  picture.show(false);
  EXPECT_EQ(picture.parts(), 0U);
}

}  // namespace underact::gui::test
