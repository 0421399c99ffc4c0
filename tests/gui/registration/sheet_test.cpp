#include "app/gui/registration/sheet.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "core/registration/sheet.h"

namespace underact::gui::test {
namespace {

constexpr QSizeF kA4_mm(210.0, 297.0);
constexpr int kPixels = 10;  // a millimetre

QImage paintedSheet(const std::vector<Vec3>& points_D) {
  QImage image((kA4_mm * kPixels).toSize(), QImage::Format_Grayscale8);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.scale(kPixels, kPixels);
  paintSheet(painter, points_D, kA4_mm);
  return image;
}

/// The middle of the mark's cross: of the columns and rows that its lines darken farthest from it, mm.
QPointF crossAt(const QImage& image, const QPointF& near_mm) {
  const auto darkest = [&](bool across) {
    double sum = 0.0, weight = 0.0;
    for (int at = -20; at <= 20; ++at) {
      for (int along = 40; along <= 60; ++along) {  // 4 to 6 mm from the middle: outside the ring
        const QPoint pixel = (near_mm * kPixels).toPoint() + (across ? QPoint(at, -along) : QPoint(-along, at));
        const double dark = 255.0 - image.pixelColor(pixel).lightness();
        const double place = across ? pixel.x() + 0.5 : pixel.y() + 0.5;
        sum += dark * place;
        weight += dark;
      }
    }
    return sum / weight / kPixels;
  };
  return {darkest(true), darkest(false)};
}

QSizeF pageOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromLatin1(file.readAll());
  const auto box = QRegularExpression(R"(/MediaBox \[0 0 ([\d.]+) ([\d.]+)\])").match(text);
  EXPECT_TRUE(box.hasMatch());
  return {box.captured(1).toDouble(), box.captured(2).toDouble()};
}

}  // namespace

TEST(RegistrationSheet, MarksLieWhereTheyAreSaidToBeToATenthOfAMillimetre) {
  const std::vector<Vec3> points_D = registration::sheetPoints(8);
  const QImage image = paintedSheet(points_D);
  const QPointF first = crossAt(image, onPage(points_D[0], points_D, kA4_mm));
  for (std::size_t at = 0; at < points_D.size(); ++at) {
    const QPointF found = crossAt(image, onPage(points_D[at], points_D, kA4_mm)) - first;
    EXPECT_NEAR(found.x(), 1e3 * registration::rightOf(points_D[at]), 0.1) << at;
    EXPECT_NEAR(found.y(), -1e3 * registration::awayOf(points_D[at]), 0.1) << at;  // away is up on the page
  }
  image.save(QString(UNDERACT_BINARY) + "/pictures/registration_sheet.png");
}

TEST(RegistrationSheet, ThePdfHasTheSizeOfItsPaper) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("sheet.pdf");
  ASSERT_TRUE(saveSheet(path, registration::sheetPoints(), Paper::A4).empty());
  EXPECT_NEAR(pageOf(path).width(), 595.0, 1.0);  // points of 1/72 inch
  EXPECT_NEAR(pageOf(path).height(), 842.0, 1.0);
  ASSERT_TRUE(saveSheet(path, registration::sheetPoints(), Paper::Letter).empty());
  EXPECT_NEAR(pageOf(path).width(), 612.0, 1.0);
  EXPECT_NEAR(pageOf(path).height(), 792.0, 1.0);
}

TEST(RegistrationSheet, RefusesASheetThatFitsNoPaper) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("no_sheet.pdf");
  EXPECT_NE(saveSheet(path, {{0, 0, 0}, {0.3, 0, 0}, {0, 0, -0.1}}, Paper::A4).front().sentence.find("do not fit"),
            std::string::npos);
  EXPECT_NE(saveSheet(path, {{0, 0, 0}, {0.1, 0, 0}, {0, 0.05, -0.1}}, Paper::A4).front().sentence.find("equal height"),
            std::string::npos);
  EXPECT_FALSE(QFile::exists(path));
  EXPECT_FALSE(saveSheet("/nowhere/sheet.pdf", registration::sheetPoints(), Paper::A4).empty());
}

}  // namespace underact::gui::test
