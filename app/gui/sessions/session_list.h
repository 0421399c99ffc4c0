#pragma once
#include <QWidget>

#include "app/gui/sessions/session_index.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace underact::gui {

/// The sessions of the folder: search, details and selection.
class SessionList : public QWidget {
  Q_OBJECT
 public:
  explicit SessionList(QWidget* parent);
  /// The commands for the selected session; above the list.
  void setTools(QWidget* tools);
  void setFolder(const QString& folder);
  /// Reads what has changed.
  void refresh();
  void setBusy(const QString& path) { index_.setBusy(path); }
  void focusSearch();
  /// The selected session; null: none.
  const SessionEntry* chosen() const;
  /// Selects a session by its path. false: it is not in the list, or not yet.
  bool choose(const QString& path);
  /// Selects it as soon as it is in the list.
  void chooseLater(const QString& path) { wanted_ = path; }

 signals:
  void chosenChanged();
  void activated();  // a double click, or Enter
  void menuAsked(const QPoint& global);
  void deleteAsked();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void rebuild();
  void filter();
  void describe();
  void say(int shown);

  SessionIndex index_;
  QString folder_, wanted_;
  QLineEdit* search_;
  QLabel* count_;
  QListWidget* list_;
  QLabel* details_;
};

}  // namespace underact::gui
