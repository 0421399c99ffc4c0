#include "app/gui/kit/page_print.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

namespace underact::gui::test {
namespace {

struct Printed {
  /// The PDF of a page.
  QByteArray of(const PaperPage& page) {
    const QString path = folder.filePath("page.pdf");
    EXPECT_TRUE(savePdf(page, path).empty());
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  }
  QTemporaryDir folder;
};

qsizetype pagesIn(const QByteArray& pdf) {
  return pdf.count("/Type /Page\n");
}

}  // namespace

TEST(PagePrint, APageIsAPdfOfAsManySheetsAsItNeeds) {
  Printed printed;
  const QByteArray one = printed.of({"Title", "# Title\n\nA formula: $\\omega_n = \\sqrt{k/m}$"});
  EXPECT_TRUE(one.startsWith("%PDF-1."));
  EXPECT_TRUE(one.trimmed().endsWith("%%EOF"));
  EXPECT_EQ(pagesIn(one), 1);
  EXPECT_GT(pagesIn(printed.of({"Long", "# Long\n\n" + QString("A paragraph.\n\n").repeated(200)})), 3);
}

TEST(PagePrint, EachWorksheetBeginsASheet) {
  Printed printed;
  const QString page = "# Sheets\n\n## 1. A\n\ntext\n\n| a | b |\n|---|---|\n| | |\n\n## 2. B\n\ntext\n";
  EXPECT_EQ(pagesIn(printed.of({"Sheets", page})), 1);
  EXPECT_EQ(pagesIn(printed.of({"Sheets", page, {}, Author::Program, true})), 3);
}

TEST(PagePrint, APictureFromElsewhereIsLeftOut) {
  Printed printed;
  QImage picture(1200, 900, QImage::Format_RGB32);
  for (int at = 0; at < 1200 * 900; ++at) picture.setPixel(at % 1200, at / 1200, static_cast<uint>(at) * 2654435761U);
  ASSERT_TRUE(picture.save(printed.folder.filePath("noise.png")));
  const auto with = [&](const char* address) {
    return printed.of({"P", QString("![p](%1)").arg(address), printed.folder.path()}).size();
  };
  EXPECT_GT(with("noise.png"), 500'000) << "in full";
  EXPECT_LT(with("../noise.png"), 100'000);
  EXPECT_LT(with("http://example.org/noise.png"), 100'000);
}

TEST(PagePrint, AFileThatCannotBeWrittenIsSaid) {
  const Problems problems = savePdf({"P", "text"}, "/nowhere/page.pdf");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.front().place.file, "/nowhere/page.pdf");
}

}  // namespace underact::gui::test
