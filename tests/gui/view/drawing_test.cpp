#include "app/gui/view/drawing.h"

#include <gtest/gtest.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>

namespace underact::gui {
namespace {

int linesOf(const DrawingPicture& picture) {
  return static_cast<int>(vtkPolyData::SafeDownCast(picture.mark()->GetMapper()->GetInput())->GetNumberOfLines());
}

TEST(Drawing, WordsAreLargeAndWhatIsNoNumberIsLeftOut) {
  DrawingPicture picture;
  Drawing drawing;
  drawing.words = {{"12 mm", Vec3::Zero()}, {"lost", Vec3::Constant(kNotANumber)}};
  drawing.styluses = {{Vec3::Zero(), Vec3::UnitZ()}, {Vec3::Constant(kNotANumber), Vec3::UnitZ()}};
  picture.draw("ghost", drawing);
  ASSERT_EQ(picture.labels().size(), 1U);
  EXPECT_TRUE(picture.labels().front().large);
  picture.draw("ghost", {});
  EXPECT_TRUE(picture.labels().empty());
}

TEST(Drawing, AStylusIsHollowAndIsGoneWithItsDrawing) {
  DrawingPicture picture;
  Drawing drawing;
  drawing.styluses = {{Vec3::Zero(), Vec3::UnitX()}};
  picture.draw("ghost", drawing);
  const int lines = linesOf(picture);
  EXPECT_GT(lines, 0);
  drawing.styluses.push_back({Vec3::Constant(kNotANumber), Vec3::UnitX()});
  picture.draw("ghost", drawing);
  EXPECT_EQ(linesOf(picture), lines);
  picture.draw("ghost", {});
  EXPECT_EQ(linesOf(picture), 0);
}

TEST(Drawing, ALengthIsOneLineAnAngleAnArcAndBothHaveTheirNames) {
  DrawingPicture picture;
  const auto lit = [&] {
    return static_cast<int>(vtkPolyData::SafeDownCast(picture.lit()->GetMapper()->GetInput())->GetNumberOfLines());
  };
  Drawing drawing;
  drawing.measures = {{"a 100 mm", 0, Vec3::Zero(), 0.1 * Vec3::UnitX()}};
  picture.draw("dh", drawing);
  const int length = lit();
  EXPECT_GT(length, 0);
  drawing.measures.push_back({"θ 90°", 2, Vec3::Zero(), 0.02 * Vec3::UnitX(), 1.57, Vec3::UnitZ()});
  drawing.measures.push_back({"lost", 2, Vec3::Zero(), Vec3::Constant(kNotANumber)});
  picture.draw("dh", drawing);
  EXPECT_GT(lit(), length);
  ASSERT_EQ(picture.labels().size(), 2U);
  EXPECT_EQ(picture.labels().back().text, "θ 90°");
  picture.draw("dh", {});
  EXPECT_EQ(lit(), 0);
}

}  // namespace
}  // namespace underact::gui
