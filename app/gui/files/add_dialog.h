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

/// What a file holds and how it is to become a part of a scene: of the one that is there, or of a new one. It stays
/// beside the window until it is added or closed.
class AddDialog : public QDialog {
  Q_OBJECT
 public:
  /// As it is asked for now.
  virtual scene::Constraint constraint() const = 0;
  /// Why it was not added; the dialog stays.
  void setRefusal(const QString& sentences);

 signals:
  void addAsked();
  void newSceneAsked();

 protected:
  /// name: "dialog.mesh", of whose parts the names begin with it. title: "Mesh %1". counts: what a screen reader calls
  /// the first line.
  AddDialog(const QString& name, const QString& title, const QString& path, const QString& counts, QWidget* parent);
  /// By the file's name: where the file has it, or, where its middle would be outside the workspace, with the middle in
  /// that of the workspace. middle: in units of the file.
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
  /// "dialog.mesh.NAME", the next one in the row at the foot.
  QPushButton* footButton(const char* name, const QString& text, const QString& tip);
  /// The refusal, and the row with its last buttons. can_add: there is a scene. add, fresh: what those buttons do, in a
  /// sentence; empty: there is nothing to add.
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
