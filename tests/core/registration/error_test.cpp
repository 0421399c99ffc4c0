#include "core/registration/error.h"

#include <gtest/gtest.h>

#include "core/registration/accuracy.h"
#include "core/registration/sheet.h"
#include "tests/core/registration/touches.h"
#include "tests/support/property.h"

namespace underact::registration {
namespace {

TEST(ExpectedError, AtTheMiddleOfTheMarksIsThatOfAMean) {
  const std::vector<Vec3> square{{0.1, 0, 0.1}, {-0.1, 0, 0.1}, {-0.1, 0, -0.1}, {0.1, 0, -0.1}};
  EXPECT_NEAR(expectedError_m(square, 1e-3, Vec3::Zero()), 0.5e-3, 1e-15);
  // Above the middle by h: d^2 = h^2 about both axes of the plane, f^2 = 0.01 there; none about the third.
  EXPECT_NEAR(expectedError_m(square, 1e-3, {0, 0.3, 0}), 1e-3 * std::sqrt((1.0 + 2.0 * 0.09 / 0.01 / 3.0) / 4.0),
              1e-15);
}

TEST(ExpectedError, TheFitHidesAPartOfTheTouches) {
  EXPECT_NEAR(touchingError_m(1e-3, 3), std::sqrt(3.0) * 1e-3, 1e-15);
  EXPECT_NEAR(touchingError_m(1e-3, 8), std::sqrt(8.0 / 6.0) * 1e-3, 1e-15);
  EXPECT_NEAR(likelyMax_m(1e-3, 4) / touchingError_m(1e-3, 4), 1.9154, 1e-3);
  for (std::size_t marks = kFewestMarks; marks < kMaxMarks; ++marks)
    EXPECT_GT(likelyMax_m(1.0, marks), likelyMax_m(1.0, marks + 1));
}

// The oracle is drawing: what the formula says against how far off thousands of registrations really are.
TEST(ExpectedError, IsWhatDrawsShow) {
  const int draws = test::sweep(4'000, 200'000);
  for (std::size_t marks = kFewestMarks; marks <= kMaxMarks; ++marks) {
    const Accuracy accuracy = accuracyOf(sheetPoints(marks), 0.3e-3, draws, 20260104 + marks);
    EXPECT_NEAR(accuracy.seen_m / accuracy.expected_m, 1.0, 0.05) << marks;
    EXPECT_NEAR(touchingError_m(accuracy.left_m, marks) / 0.3e-3, 1.0, 0.05) << marks;
    EXPECT_NEAR(accuracy.covered, 0.95, 0.02) << marks;
    EXPECT_GT(accuracy.twentieth_m, accuracy.seen_m);
  }
}

TEST(ExpectedError, GrowsWithTheErrorOfTheTouchesAndFallsWithMoreMarks) {
  const Accuracy few = accuracyOf(sheetPoints(3), 1e-3, 2000, 5), many = accuracyOf(sheetPoints(8), 1e-3, 2000, 5);
  EXPECT_LT(many.seen_m, few.seen_m);
  EXPECT_NEAR(expectedError_m(sheetPoints(3), 2e-3, kMiddle_D), 2.0 * expectedError_m(sheetPoints(3), 1e-3, kMiddle_D),
              1e-15);
  EXPECT_EQ(accuracyOf(sheetPoints(3), 1e-3, 50, 5).seen_m, accuracyOf(sheetPoints(3), 1e-3, 50, 5).seen_m);
}

TEST(ExpectedError, OfTheMiddleIsThatOfTheArmsOwnMiddle) {
  test::Random random({7});
  const std::vector<Touch> touches = touched(sheetPoints(5), standing(0.7), 1e-3, random);
  const Fit fit = fitTouches(touches).value();
  const ErrorInTheMiddle middle = errorInTheMiddle(touches, fit);
  EXPECT_NEAR(middle.expected_m, expectedError_m(sheetPoints(5), touchingError_m(fit.rms_m, 5), fit.X_DW.translation()),
              1e-15);
  EXPECT_GT(middle.likely_max_m, middle.expected_m);
}

}  // namespace
}  // namespace underact::registration
