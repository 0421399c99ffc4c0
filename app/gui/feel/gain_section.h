#pragma once
#include <QString>
#include <QWidget>
#include <array>

#include "app/gui/feature/gain_row.h"
#include "core/scene/description.h"

class QCheckBox;

namespace underact::gui {

/// The gains that the control law uses, axis by axis, and whether the axes are linked.
class GainSection : public QWidget {
  Q_OBJECT
 public:
  explicit GainSection(QWidget* parent = nullptr);
  /// Links the axes if their gains are equal.
  void begin(const scene::Control& control);
  /// own: the values in the scene file.
  void present(const scene::Control& now, const scene::Control& own);
  /// A warning at the stiffness of an axis; empty: none.
  void setWarning(int axis, const QString& reason);
  bool isHeld() const;

  /// The axes of a gain after a change of one of them, or of all if linked, and the text of the undo menu.
  struct Wanted {
    Vec3 axes;
    QString what;
  };
  Wanted changed(const scene::Control& control, int gain, int axis, double value) const;

 signals:
  /// gain: 0 kp, 1 kd, 2 ki; axis: 0 x, 1 y, 2 z; fresh: a separate undo step.
  void asked(int gain, int axis, double value, bool fresh);

 private:
  void showRows();

  QCheckBox* link_;
  std::array<QWidget*, kGainKinds> parts_{};
  std::array<std::array<GainRow*, 3>, kGainKinds> rows_{};
  scene::Control now_;               // shown last
  std::array<QString, 3> warnings_;  // of the stiffness
};

}  // namespace underact::gui
