#include "app/gui/view/view_words.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/gui/kit/larger_font.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/view/axis_gizmo.h"
#include "app/gui/view/label_places.h"

namespace underact::gui {
namespace {

constexpr double kPlate = 3.0;         // beside a label
constexpr double kWordsMargin = 16.0;  // from the view's edges; spacing by a 4-pixel grid

QString newtons(double force_N) {
  return localNumber(force_N, 'f', 2);
}

}  // namespace

const QImage& Stamp::image(const QString& key, const QSizeF& size, double scale, const Paint& paint) {
  const QSize pixels = (size * scale).toSize().expandedTo({1, 1});
  if (key == key_ && pixels == image_.size()) return image_;
  key_ = key;
  image_ = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
  image_.setDevicePixelRatio(scale);
  image_.fill(Qt::transparent);
  QPainter painter(&image_);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  paint(painter, size);
  return image_;
}

void ViewWords::paint(QPainter& painter, const WordsState& state, const std::vector<Label>& labels) {
  paintLabels(painter, state, labels);
  paintTriad(painter, state);
  paintLegend(painter, state);
  paintGauge(painter, state);
  paintHint(painter, state);
  if (!state.focus) return;
  const double w = state.size.width(), h = state.size.height();
  for (const QRectF& side :
       {QRectF(0, 0, w, 2), QRectF(0, h - 2, w, 2), QRectF(0, 2, 2, h - 4), QRectF(w - 2, 2, 2, h - 4)}) {
    painter.fillRect(side, state.theme.constraint);
  }
}

void ViewWords::paintLabels(QPainter& painter, const WordsState& state, const std::vector<Label>& labels) {
  const QFont plain = larger(state.font, 0.85);
  QFont strong = larger(state.font, 0.95), large = larger(state.font, 1.5);
  strong.setBold(true);
  large.setBold(true);
  const auto fontOf = [&](const Label& label) -> const QFont& {
    return label.large ? large : label.strong ? strong : plain;
  };
  std::vector<const Label*> seen;
  for (const Label& label : labels) {
    if (project(state.camera, state.size, label.p_mm).depth_mm > 0.0) seen.push_back(&label);
  }
  // Large words first, then names, then the digits of ticks: what comes later gives way.
  std::stable_sort(seen.begin(), seen.end(), [](const Label* a, const Label* b) {
    return std::pair(a->large, a->strong) > std::pair(b->large, b->strong);
  });
  std::vector<WantedLabel> wanted;
  for (const Label* label : seen) {
    const QFontMetricsF metrics(fontOf(*label));
    const double width = metrics.horizontalAdvance(label->text), height = metrics.ascent() + metrics.descent();
    const QPointF place = project(state.camera, state.size, label->p_mm).pixel;
    const double down = label->large ? metrics.height() : 0.0;
    const QPointF base(std::round(place.x() - 0.5 * width),
                       std::round(place.y() + 0.5 * (metrics.ascent() - metrics.descent()) + down));
    wanted.push_back({label->text, QRectF(base.x(), base.y() - metrics.ascent(), width, height), !label->large});
  }
  const QPointF gizmo = AxisGizmo::middle(state.size);
  const double half = 0.5 * AxisGizmo::kSide;
  const std::vector<std::optional<QPointF>> places =
      placesOfLabels(wanted, {QRectF(gizmo - QPointF(half, half), gizmo + QPointF(half, half))});
  for (std::size_t index = 0; index < seen.size(); ++index) {
    if (!places[index]) continue;
    const Label& label = *seen[index];
    const QFontMetricsF metrics(fontOf(label));
    const QRectF at = wanted[index].where.translated(*places[index]);
    if (label.large || !label.strong) {  // thin words may stand over an arm of their own shade
      painter.fillRect(QRectF(at.left() - kPlate, at.top(), at.width() + 2.0 * kPlate, metrics.height()),
                       label.large ? state.theme.background : faint(state.theme.background, 0.6));
    }
    const QPointF base(at.left(), at.top() + metrics.ascent());
    painter.setFont(fontOf(label));
    if (label.strong && !label.large) {  // a rim, so that names can be read over an arm of their own shade
      painter.setPen(state.theme.background);
      for (const QPointF& off : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)})
        painter.drawText(base + off, label.text);
    }
    painter.setPen(readable(label.colour, state.theme));
    painter.drawText(base, label.text);
  }
}

void ViewWords::paintLegend(QPainter& painter, const WordsState& state) {
  if (!state.has_influence) return;
  struct Row {
    QString letter, text;
    QColor colour;
  };
  const std::array<Row, 2> rows{
      Row{"o", QCoreApplication::translate("SceneView", "where the stylus points"), state.theme.orientation},
      Row{"p", QCoreApplication::translate("SceneView", "nearest to the tip"), state.theme.position}};
  QFont strong = larger(state.font, 0.95);
  strong.setBold(true);
  const QFont plain = larger(state.font, 0.85);
  const double line = std::ceil(QFontMetricsF(strong).height());
  double base = std::round(state.size.height() - AxisGizmo::kSide - kWordsMargin - line);
  for (const Row& row : rows) {
    painter.setFont(strong);
    painter.setPen(readable(row.colour, state.theme));
    painter.drawText(QPointF(kWordsMargin, base), row.letter);
    painter.setFont(plain);
    painter.setPen(mixed(state.theme.quiet, state.theme.ink, 0.6));
    painter.drawText(QPointF(kWordsMargin + 16.0, base), row.text);
    base += line;
  }
}

void ViewWords::paintGauge(QPainter& painter, const WordsState& state) {
  if (state.force_limit_N <= 0.0) return;
  const double large = state.gauge_scale;
  const QFont font = larger(state.font, large);
  const QFontMetricsF metrics(font);
  const QString now = newtons(state.force_N), rest = QStringLiteral(" / %1 N").arg(newtons(state.force_limit_N));
  const QString title = QCoreApplication::translate("SceneView", "Force");
  const double rest_width = metrics.horizontalAdvance(rest);
  const double width = std::ceil(std::max(
      large * 176.0, metrics.horizontalAdvance(title + QStringLiteral("  00.00")) + rest_width + large * 24.0));
  const QSizeF size(width, std::ceil(metrics.height()) + large * 10.0 + 6.0);
  const double share = std::clamp(state.force_N / state.force_limit_N, 0.0, 1.0);
  const double filled = std::round(share * width * state.scale) / state.scale;
  const QString key = now + rest + QString::number(filled) + QLatin1Char(state.limited ? '!' : ' ') +
                      state.theme.ink.name() + font.key();
  const QImage& image = gauge_.image(key, size, state.scale, [&](QPainter& p, const QSizeF& area) {
    const QRectF line(0, 0, area.width(), metrics.height());
    p.setFont(font);
    p.setPen(mixed(state.theme.quiet, state.theme.ink, 0.6));
    p.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, title);
    p.drawText(line, Qt::AlignRight | Qt::AlignVCenter, rest);
    QFont bold = font;
    bold.setBold(true);
    p.setFont(bold);
    p.setPen(state.theme.ink);
    p.drawText(line.adjusted(0, 0, -rest_width, 0), Qt::AlignRight | Qt::AlignVCenter, now);
    const QRectF track(0.5, metrics.height() + 6.0, area.width() - 1.0, large * 6.0);
    p.setPen(Qt::NoPen);
    p.setBrush(mixed(state.theme.background, state.theme.quiet, 0.55));
    p.drawRoundedRect(track, 3.0 * large, 3.0 * large);
    p.setBrush(state.limited ? state.theme.force_limited : state.theme.force);
    p.setClipRect(QRectF(0, 0, filled, area.height()));
    p.drawRoundedRect(track, 3.0 * large, 3.0 * large);
    p.setClipping(false);
    if (state.limited)
      p.drawRect(
          QRectF(area.width() - 3.0 * large, metrics.height() + 2.0, 3.0 * large, 6.0 * large + 8.0));  // cut here
  });
  const QPointF corner(std::round(state.size.width() - width - kWordsMargin),
                       std::round(state.size.height() - size.height() - kWordsMargin));
  painter.setPen(Qt::NoPen);
  painter.setBrush(faint(state.theme.background, 0.85));  // over the box's ticks
  painter.drawRoundedRect(QRectF(corner, size).adjusted(-6, -3, 6, 5), 6, 6);
  painter.drawImage(corner, image);
}

void ViewWords::paintHint(QPainter& painter, const WordsState& state) {
  const bool fault = !state.fault.isEmpty();
  const QString text = fault ? state.fault : state.hint;
  if (text.isEmpty()) return;
  const QFontMetricsF metrics(state.font);
  const double widest = std::max(120.0, state.size.width() - 4.0 * kWordsMargin);
  const QRectF wanted =
      metrics.boundingRect(QRectF(0, 0, widest - 32.0, 1e4), Qt::AlignCenter | Qt::TextWordWrap, text);
  const QSizeF size(std::ceil(wanted.width()) + 32.0, std::ceil(wanted.height()) + 16.0);
  const QString key = text + QLatin1Char(fault ? '!' : ' ') + state.theme.ink.name() + state.font.key();
  const QImage& image = hint_.image(key, size, state.scale, [&](QPainter& p, const QSizeF& area) {
    const QColor signal = state.theme.dark ? QColor(0xFF, 0x8A, 0x4C) : QColor(0xB0, 0x3A, 0x00);
    p.setPen(QPen(fault ? state.theme.force_limited : mixed(state.theme.background, state.theme.quiet, 0.7), 1.0));
    p.setBrush(mixed(state.theme.background, Qt::white, state.theme.dark ? 0.06 : 0.8));
    p.drawRoundedRect(QRectF(0.5, 0.5, area.width() - 1.0, area.height() - 1.0), 8, 8);
    p.setFont(state.font);
    p.setPen(fault ? signal : state.theme.ink);
    p.drawText(QRectF(QPointF(16, 8), area - QSizeF(32, 16)), Qt::AlignCenter | Qt::TextWordWrap, text);
  });
  painter.drawImage(QPointF(std::round(0.5 * (state.size.width() - size.width())), kWordsMargin), image);
}

void ViewWords::paintTriad(QPainter& painter, const WordsState& state) {
  QString key = state.theme.ink.name() + state.theme.background.name() + state.font.key();
  for (const Vec3& direction : {state.camera.right_W(), state.camera.back_W()})
    key += QStringLiteral(" %1 %2 %3").arg(direction.x()).arg(direction.y()).arg(direction.z());
  constexpr double kSide = AxisGizmo::kSide;
  const QImage& image = triad_.image(key, {kSide, kSide}, state.scale, [&](QPainter& p, const QSizeF&) {
    AxisGizmo::paint(p, state.camera, state.theme, state.font);
  });
  painter.drawImage(AxisGizmo::middle(state.size) - QPointF(0.5 * kSide, 0.5 * kSide), image);
}

}  // namespace underact::gui
