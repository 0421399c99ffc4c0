#pragma once
#include <array>

#include "app/gui/kit/section.h"
#include "app/gui/sessions/stylus_buttons.h"

class QComboBox;

namespace underact::gui {

/// Actions assigned to the stylus buttons, in addition to their use by the servo.
class ButtonsSection : public Section {
  Q_OBJECT
 public:
  explicit ButtonsSection(QWidget* parent = nullptr);
  /// Call with every tick.
  void add(const servo::TickRecord& record);
  /// With hold to run, the button at the tip enables the force and has no other action.
  void setHoldToRun(bool on);

 signals:
  void pressed(underact::gui::ButtonUse use);

 private:
  ButtonUse use(int button) const;
  ButtonEdges edges_;
  std::array<QComboBox*, kStylusButtons> uses_{};
};

}  // namespace underact::gui
