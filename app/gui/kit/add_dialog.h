#pragma once
#include <QDialog>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace underact::gui {

/// What a file holds and how it is to become a part of a scene: of the one that is there, or of a new one. It stays
/// beside the window until it is added or closed.
class AddDialog : public QDialog {
  Q_OBJECT
 public:
  /// Why it was not added; the dialog stays.
  void setRefusal(const QString& sentences);

 signals:
  void addAsked();
  void newSceneAsked();

 protected:
  /// name: "dialog.mesh", of whose parts the names begin with it. counts: what a screen reader calls the first line.
  AddDialog(const QString& name, const QString& title, const QString& counts, QWidget* parent);
  QVBoxLayout* column() { return column_; }
  QLabel* counts() const { return counts_; }
  /// "dialog.mesh.NAME", the next one in the row at the foot.
  QPushButton* footButton(const char* name, const QString& text, const QString& tip);
  /// The refusal, and the row with its last buttons. can_add: there is a scene. add, fresh: what those buttons do, in a
  /// sentence; empty: there is nothing to add.
  void layFoot(bool can_add, const QString& add, const QString& fresh);

 private:
  QVBoxLayout* column_;
  QLabel *counts_, *refusal_;
  QHBoxLayout* foot_;
};

}  // namespace underact::gui
