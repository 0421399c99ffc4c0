#pragma once
#include <QImage>
#include <QString>

namespace underact::gui::test {

// What a picture may differ by from its reference, without text (fonts differ). On one machine two runs are equal;
// between versions of llvmpipe and CPUs an edge may lie a pixel further on: a dark line 2 pixels wide that is half a
// pixel elsewhere changes a block of 16 x 16 by 0.03. A force arrow that is missing changes one by more than 0.2.
inline constexpr double kTolerance = 0.08;

/// The largest difference of means over blocks of 16 x 16 pixels and over red, green and blue, 0 to 1; 1 where sizes
/// differ.
double worstBlockDifference(const QImage& a, const QImage& b);

/// The picture against tests/stories/reference/NAME.png. With UNDERACT_UPDATE_PICTURES=1 the reference is written
/// instead. The picture itself is kept in the build tree (pictures/), so that a difference can be looked at.
double differenceFromReference(const QImage& picture, const QString& name);

}  // namespace underact::gui::test
