#pragma once
#include <QDialog>
#include <QString>
#include <utility>

#include "core/scene/description.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace underact::gui {

/// Shows the content of a file and asks how to add it to a scene: to the present one, or to a new one. It stays open
/// beside the window until the content is added or the dialog is closed.
class AddDialog : public QDialog {
  Q_OBJECT
 public:
  /// As chosen in the dialog.
  virtual scene::Constraint constraint() const = 0;
  /// Why it was not added; the dialog stays open.
  void setRefusal(const QString& sentences);

 signals:
  void addAsked();
  void newSceneAsked();

 protected:
  /// name: "dialog.mesh", the prefix of the names of its widgets. title: "Mesh %1". counts: the accessible name of the
  /// first line.
  AddDialog(const QString& name, const QString& title, const QString& path, const QString& counts, QWidget* parent);
  /// A constraint named after the file: with the coordinates of the file or, if its middle would be outside the
  /// workspace, moved to the middle of the workspace. middle: in units of the file.
  template <class Shape>
  scene::Constraint fromFile(Shape shape, double mm_per_unit, const Vec3& middle) const {
    shape.file = path_.toStdString();
    shape.scale_mm_per_unit = mm_per_unit;
    shape.X_WM = placeWithin(mm_per_unit * middle);
    scene::Constraint constraint;
    constraint.name = nameOfFile();
    constraint.shape = std::move(shape);
    return constraint;
  }
  QVBoxLayout* column() { return column_; }
  QLabel* counts() const { return counts_; }
  /// Adds the button "dialog.mesh.NAME" to the row at the bottom.
  QPushButton* footButton(const char* name, const QString& text, const QString& tip);
  /// Lays out the refusal and the row of buttons. can_add: there is a scene. add, fresh: the tool tips of those
  /// buttons; empty: there is nothing to add.
  void layFoot(bool can_add, const QString& add, const QString& fresh);

 private:
  static Eigen::Matrix4d placeWithin(const Vec3& middle_mm);
  std::string nameOfFile() const;

  QString path_;  // absolute
  QVBoxLayout* column_;
  QLabel *counts_, *refusal_;
  QHBoxLayout* foot_;
};

}  // namespace underact::gui
