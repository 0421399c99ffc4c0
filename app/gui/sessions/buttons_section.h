#pragma once
#include <array>

#include "app/gui/kit/section.h"
#include "app/gui/sessions/stylus_buttons.h"

class QComboBox;

namespace underact::gui {

/// What the stylus buttons do besides what the servo makes of them.
class ButtonsSection : public Section {
  Q_OBJECT
 public:
  explicit ButtonsSection(QWidget* parent = nullptr);
  /// Every tick.
  void add(const servo::TickRecord& record);
  /// With hold to run the button at the tip lets the servo push, and does nothing else.
  void setHoldToRun(bool on);

 signals:
  void pressed(underact::gui::ButtonUse use);

 private:
  ButtonUse use(int button) const;
  ButtonEdges edges_;
  std::array<QComboBox*, kStylusButtons> uses_{};
};

}  // namespace underact::gui
