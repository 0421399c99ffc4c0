#pragma once
#include <QMessageBox>

namespace underact::gui {

/// Asks whether to delete a session. Not modal; deleted when answered. Esc and Enter keep the session.
class DeleteQuestion : public QMessageBox {
  Q_OBJECT
 public:
  using QMessageBox::QMessageBox;

 signals:
  void binWanted();
  void removalWanted();
};

/// Offers to move the session to the bin, or to delete it permanently.
DeleteQuestion* askToDelete(const QString& title, const QString& path, QWidget* window);

/// Confirms the permanent deletion, which cannot be undone.
DeleteQuestion* askToRemove(const QString& title, const QString& path, QWidget* window);

}  // namespace underact::gui
