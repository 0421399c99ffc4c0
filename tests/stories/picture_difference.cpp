#include "tests/stories/picture_difference.h"

#include <QDir>
#include <algorithm>
#include <array>
#include <cmath>

namespace underact::gui::test {
namespace {

constexpr int kBlock = 16;

std::array<double, 3> meanOf(const QImage& image, int left, int top) {
  std::array<double, 3> sum{};
  const int right = std::min(left + kBlock, image.width()), bottom = std::min(top + kBlock, image.height());
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const QRgb pixel = image.pixel(x, y);
      sum[0] += qRed(pixel);
      sum[1] += qGreen(pixel);
      sum[2] += qBlue(pixel);
    }
  }
  for (double& channel : sum) channel /= 255.0 * (right - left) * (bottom - top);
  return sum;
}

}  // namespace

double worstBlockDifference(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull()) return 1.0;
  double worst = 0.0;
  for (int top = 0; top < a.height(); top += kBlock) {
    for (int left = 0; left < a.width(); left += kBlock) {
      const std::array<double, 3> first = meanOf(a, left, top), second = meanOf(b, left, top);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        worst = std::max(worst, std::abs(first[channel] - second[channel]));
      }
    }
  }
  return worst;
}

double differenceFromReference(const QImage& picture, const QString& name) {
  const QString reference = QString(UNDERACT_SOURCE) + "/tests/stories/reference/" + name + ".png";
  QDir().mkpath(QString(UNDERACT_BINARY) + "/pictures");
  picture.save(QString(UNDERACT_BINARY) + "/pictures/" + name + ".png");
  if (qEnvironmentVariableIsSet("UNDERACT_UPDATE_PICTURES")) {
    QDir().mkpath(QString(UNDERACT_SOURCE) + "/tests/stories/reference");
    return picture.save(reference) ? 0.0 : 1.0;
  }
  return worstBlockDifference(picture.convertToFormat(QImage::Format_RGB32),
                              QImage(reference).convertToFormat(QImage::Format_RGB32));
}

}  // namespace underact::gui::test
