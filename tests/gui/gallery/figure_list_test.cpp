#include "app/gui/gallery/figure_list.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include "app/gui/gallery/figure_pdf.h"

namespace underact::gui::test {
namespace {

constexpr const char* kFigures = R"([
 {"figure": "4.5", "title": "A", "pictures": ["a.png", "a.pdf"], "passed": false,
  "numbers": [{"what": "x", "measured": 1.0, "expected": 1.0, "tolerance": 0.1, "passed": true},
              {"what": "y", "measured": null, "expected": 2.0, "passed": false}]},
 {"figure": "B.1", "left_out": "No screen."},
 {"figure": "B.2", "problem": "It ended."},
 {"figure": "B.3", "pictures": ["v.png"]}])";

void writeFile(const QString& path, const QByteArray& text) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
}

}  // namespace

TEST(FigureList, EachFigureSaysWhatCameOfIt) {
  const QTemporaryDir folder;
  writeFile(folder.filePath("figures.json"), kFigures);
  const Result<FigureList> read = readFigures(folder.path());
  ASSERT_TRUE(read);
  const std::vector<FigureRow>& rows = read.value().rows;
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(verdictOf(rows[0]), QString("1 of 2 numbers fail"));
  EXPECT_FALSE(rows[0].numbers[1].measured.has_value());
  EXPECT_EQ(rows[0].picture, folder.filePath("a.png"));
  EXPECT_EQ(rows[0].pdf, folder.filePath("a.pdf"));
  EXPECT_EQ(verdictOf(rows[1]), QString("left out"));
  EXPECT_EQ(verdictOf(rows[2]), QString("not made"));
  EXPECT_EQ(verdictOf(rows[3]), QString("picture of the view"));
  EXPECT_EQ(verdictOf(read.value()), QString("4 figures, 2 numbers checked, 2 failed. Figures left out: 1."));
}

TEST(FigureList, NamesAFileThatIsMissingOrNoList) {
  const QTemporaryDir folder;
  const Result<FigureList> none = readFigures(folder.path());
  ASSERT_FALSE(none);
  EXPECT_EQ(none.problems().front().sentence, "The figures have not been made yet.");
  writeFile(folder.filePath("figures.json"), "[]");
  const Result<FigureList> empty = readFigures(folder.path());
  ASSERT_FALSE(empty);
  EXPECT_NE(empty.problems().front().sentence.find("Make the figures again"), std::string::npos);
}

TEST(FigureList, WhoMadeThemAndWhenIsReadBack) {
  const QTemporaryDir folder;
  writeFile(folder.filePath("figures.json"), kFigures);
  const QDateTime when(QDate(2026, 11, 21), QTime(19, 56, 47));
  ASSERT_TRUE(markFigures(folder.path(), "0.1.0", when));
  EXPECT_EQ(readFigures(folder.path()).value().program_version, QString("0.1.0"));
  EXPECT_EQ(readFigures(folder.path()).value().made, when);
  EXPECT_FALSE(markFigures("/no/such/folder", "0.1.0", when));
}

TEST(FigurePdf, APictureAloneBecomesAPageAndWithoutOneItIsSaid) {
  const QTemporaryDir folder;
  FigureRow row;
  row.key = "4.5";
  EXPECT_EQ(saveFigurePdf(row, folder.filePath("out.pdf")), QString("Figure 4.5 has no picture."));
  QImage picture(70, 30, QImage::Format_RGB32);
  picture.fill(Qt::red);
  row.picture = folder.filePath("a.png");
  ASSERT_TRUE(picture.save(row.picture));
  EXPECT_EQ(saveFigurePdf(row, folder.filePath("out.pdf")), QString());
  QFile made(folder.filePath("out.pdf"));
  ASSERT_TRUE(made.open(QIODevice::ReadOnly));
  const QByteArray pdf = made.readAll();
  EXPECT_TRUE(pdf.startsWith("%PDF") && pdf.contains("504")) << "7 inches are 504 points";
}

}  // namespace underact::gui::test
