#include "app/gui/lessons/lesson_card.h"

#include <QApplication>
#include <QListWidget>
#include <QPainter>

#include "app/gui/kit/theme.h"

namespace underact::gui {
namespace {

constexpr int kGap_px = 8, kBar_px = 4;

QFont titleFont(const QWidget& list) {
  QFont font = list.font();
  font.setWeight(QFont::DemiBold);
  return font;
}

/// Of the circle with the number.
int circle_px(const QWidget& list) {
  return 2 * list.fontMetrics().height() - kGap_px / 2;
}

}  // namespace

QString cardLine(int minutes, int steps, int solved) {
  if (solved >= steps) return LessonCard::tr("%1 min, all steps solved").arg(minutes);
  return solved == 0 ? LessonCard::tr("%1 min, %2 steps").arg(minutes).arg(steps)
                     : LessonCard::tr("%1 min, %2 of %3 steps solved").arg(minutes).arg(solved).arg(steps);
}

LessonCard::LessonCard(QListWidget* list) : QStyledItemDelegate(list), list_(list) {}

QRect LessonCard::titleRect(const QModelIndex& index, const QPoint& corner) const {
  const int left = kGap_px + circle_px(*list_) + kGap_px;
  const int width = std::max(40, list_->viewport()->width() - left - kGap_px);
  return QFontMetrics(titleFont(*list_))
      .boundingRect(QRect(corner + QPoint(left, kGap_px), QSize(width, 10'000)), Qt::TextWordWrap,
                    index.data(Qt::DisplayRole).toString());
}

QSize LessonCard::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  if (index.data(Path).toString().isEmpty()) return QStyledItemDelegate::sizeHint(option, index);
  const int text = titleRect(index, {}).height() + list_->fontMetrics().lineSpacing() + kGap_px + kBar_px;
  return {0, std::max(text, circle_px(*list_)) + 2 * kGap_px};
}

void LessonCard::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  if (index.data(Path).toString().isEmpty()) return QStyledItemDelegate::paint(painter, option, index);
  QStyleOptionViewItem frame = option;
  initStyleOption(&frame, index);
  frame.text.clear();
  list_->style()->drawControl(QStyle::CE_ItemViewItem, &frame, painter, list_);  // hover, selection, focus
  const QColor ground = QApplication::palette().color(QPalette::Window),
               ink = QApplication::palette().color(QPalette::Text);
  const QColor done = Theme().target;
  const int number = index.data(Number).toInt(), steps = index.data(Steps).toInt(), solved = index.data(Solved).toInt();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const int across = circle_px(*list_);
  const QRect circle(option.rect.topLeft() + QPoint(kGap_px, kGap_px), QSize(across, across));
  const bool is_done = solved >= steps;
  painter->setPen(QPen(is_done ? done : mixed(ground, ink, 0.5), 1.6));
  painter->setBrush(is_done ? done : QColor(Qt::transparent));
  painter->drawEllipse(circle.adjusted(1, 1, -1, -1));
  painter->setFont(titleFont(*list_));
  painter->setPen(is_done ? QColor(Qt::white) : ink);
  const QString inside = is_done ? QStringLiteral("✓") : number > 0 ? QString::number(number) : QStringLiteral("•");
  painter->drawText(circle, Qt::AlignCenter, inside);
  const QRect title = titleRect(index, option.rect.topLeft());
  painter->setPen(ink);
  painter->drawText(title, Qt::TextWordWrap, index.data(Qt::DisplayRole).toString());
  painter->setFont(list_->font());
  painter->setPen(mixed(ground, ink, 0.68));
  const QRect line(title.left(), title.bottom() + 2, option.rect.right() - title.left() - kGap_px,
                   list_->fontMetrics().lineSpacing());
  painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter, cardLine(index.data(Minutes).toInt(), steps, solved));
  QRectF bar(line.left(), line.bottom() + 3, line.width(), kBar_px);
  painter->setPen(Qt::NoPen);
  painter->setBrush(mixed(ground, ink, 0.16));
  painter->drawRoundedRect(bar, kBar_px / 2.0, kBar_px / 2.0);
  if (solved > 0 && steps > 0) {
    bar.setWidth(bar.width() * solved / steps);
    painter->setBrush(done);
    painter->drawRoundedRect(bar, kBar_px / 2.0, kBar_px / 2.0);
  }
  painter->restore();
}

}  // namespace underact::gui
