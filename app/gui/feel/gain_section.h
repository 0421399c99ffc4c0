#pragma once
#include <QWidget>
#include <array>

#include "app/gui/feature/gain_row.h"
#include "core/scene/description.h"

class QCheckBox;

namespace underact::gui {

/// The gains of the law, axis by axis: those it uses, and whether a change of one axis changes all three.
class GainSection : public QWidget {
  Q_OBJECT
 public:
  explicit GainSection(QWidget* parent = nullptr);
  /// The axes are linked where their gains are alike.
  void begin(const scene::Control& control);
  /// own: as the file has it.
  void present(const scene::Control& now, const scene::Control& own);
  /// Of the stiffness of an axis; empty: calm.
  void setWarning(int axis, const QString& reason);
  bool isHeld() const;

  /// A gain with another value along an axis, or along all that are linked to it, and what is undone by that.
  struct Wanted {
    Vec3 axes;
    QString what;
  };
  Wanted changed(const scene::Control& control, int gain, int axis, double value) const;

 signals:
  /// gain: 0 kp, 1 kd, 2 ki; axis: 0 x, 1 y, 2 z; fresh: a step of its own for undo.
  void asked(int gain, int axis, double value, bool fresh);

 private:
  QCheckBox* link_;
  std::array<QWidget*, kGainKinds> parts_{};
  std::array<std::array<GainRow*, 3>, kGainKinds> rows_{};
};

}  // namespace underact::gui
