#pragma once
#include <QMessageBox>

namespace underact::gui {

/// Asks whether a session is to go. Not modal; gone when it is answered. Esc and Enter leave the session where it is.
class DeleteQuestion : public QMessageBox {
  Q_OBJECT
 public:
  using QMessageBox::QMessageBox;

 signals:
  void binWanted();
  void removalWanted();
};

/// To the bin, which keeps it, or for good.
DeleteQuestion* askToDelete(const QString& title, const QString& path, QWidget* window);

/// For good: nothing brings it back.
DeleteQuestion* askToRemove(const QString& title, const QString& path, QWidget* window);

}  // namespace underact::gui
