#include "app/gui/view/label_places.h"

#include <gtest/gtest.h>

namespace underact::gui {

TEST(LabelPlaces, NoneLiesOverAnotherOrOverWhatIsTakenAndTheFirstOnesStay) {
  std::vector<WantedLabel> labels;
  for (int index = 0; index < 9; ++index)
    labels.push_back({QString::number(index), QRectF(100.0 + 3.0 * index, 100.0 + 2.0 * index, 20.0, 12.0)});
  const QRectF taken(90.0, 80.0, 60.0, 15.0);
  const std::vector<std::optional<QPointF>> places = placesOfLabels(labels, {taken});
  ASSERT_EQ(places.size(), labels.size());
  EXPECT_EQ(places.front(), QPointF(0.0, 0.0));
  std::vector<QRectF> drawn{taken};
  int moved = 0;
  for (std::size_t index = 0; index < labels.size(); ++index) {
    if (!places[index]) continue;
    const QRectF at = labels[index].where.translated(*places[index]);
    for (const QRectF& other : drawn) EXPECT_FALSE(at.intersects(other)) << index;
    drawn.push_back(at);
    moved += places[index]->isNull() ? 0 : 1;
  }
  EXPECT_GT(moved, 2);
}

TEST(LabelPlaces, ATextThatStandsThereAlreadyIsNotRepeatedAndLargeWordsStayWhereTheyAre) {
  const QRectF where(10.0, 10.0, 30.0, 12.0), beside(15.0, 12.0, 30.0, 12.0);
  const std::vector<std::optional<QPointF>> places =
      placesOfLabels({{"V", where}, {"V", beside}, {"V", beside.translated(200.0, 0.0)}, {"12 mm", beside, false}}, {});
  EXPECT_TRUE(places[0]);
  EXPECT_FALSE(places[1]);
  EXPECT_TRUE(places[2]);   // elsewhere: another one
  EXPECT_FALSE(places[3]);  // no room where it has to be
}

}  // namespace underact::gui
