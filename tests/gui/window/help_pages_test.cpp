#include <gtest/gtest.h>

#include <QDirIterator>
#include <QRegularExpression>

#include "tests/gui/guide_pages.h"

namespace underact::gui::test {
TEST(HelpPages, EveryDialogHasARowOfItsOwnInThePagesForF1) {
  const QRegularExpression dialog("\"(dialog\\.[a-z_]+)\"");
  int dialogs = 0;
  for (QDirIterator files(QString(UNDERACT_SOURCE) + "/app/gui", {"*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
       files.hasNext();) {
    QFile file(files.next());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    for (const QRegularExpressionMatch& match : dialog.globalMatch(text)) {
      const QString name = match.captured(1);
      // Of a name that is put together ("dialog.add_" and a kind) the beginning stands here.
      EXPECT_TRUE(std::any_of(allPages().begin(), allPages().end(),
                              [&](const HelpPage& page) {
                                const QLatin1String part(page.part);
                                return name == part || (name.endsWith('_') && part.startsWith(name));
                              }))
          << name.toStdString() << ": the feature.cpp of its room names its page";
      ++dialogs;
    }
  }
  EXPECT_GT(dialogs, 25);
}

TEST(HelpPages, EveryRowOfThePagesForF1LeadsToAHeadingThatIsThere) {
  for (const HelpPage& row : allPages()) EXPECT_TRUE(isPlace(row.place)) << row.part << ": " << row.place;
  EXPECT_EQ(helpPageOf(nullptr, allPages()), QString("start"));
  QWidget part;
  part.setObjectName("panel.kinematics.solutions.again");
  EXPECT_EQ(helpPageOf(&part, allPages()), QString("kinematics#inverse-solutions"));
  part.setObjectName("panel.kinematicsx");  // goes on without a dot: another thing
  EXPECT_EQ(helpPageOf(&part, allPages()), QString("start"));
}

}  // namespace underact::gui::test
