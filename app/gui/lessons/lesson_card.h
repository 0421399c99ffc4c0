#pragma once
#include <QStyledItemDelegate>

class QListWidget;

namespace underact::gui {

/// Draws a lesson of the list as a card: its number, or a tick, its title, how long it takes and how far it is done,
/// and a bar of that. Items without a path are headings.
class LessonCard : public QStyledItemDelegate {
  Q_OBJECT
 public:
  /// What an item says besides its text, the title.
  enum Role { Path = Qt::UserRole, About, Number, Minutes, Steps, Solved };

  explicit LessonCard(QListWidget* list);
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  QRect titleRect(const QModelIndex& index, const QPoint& corner) const;

  QListWidget* list_;
};

/// "12 min, 5 steps", "12 min, 2 of 5 steps solved".
QString cardLine(int minutes, int steps, int solved);

}  // namespace underact::gui
