#pragma once
#include "app/gui/kit/value_row.h"

namespace underact::gui {

/// One of the three gains of a control law, as the window shows it.
struct GainKind {
  const char* key;     // "kp"
  const char* name;    // "Stiffness"
  const char* path;    // in the table of settings: "/control/kp_N_per_mm"
  int steps_per_unit;  // of the slider and the arrows
  int slider_steps;    // from 0 to the slider's end; larger values can be typed
  int decimals;
};

inline constexpr int kGainKinds = 3;
const GainKind& gainKind(int gain);  // 0 kp, 1 kd, 2 ki
ValueKind gainValueKind(int gain);

/// One gain of one axis (or joint).
class GainRow : public ValueRow {
  Q_OBJECT
 public:
  GainRow(int gain, int axis, QWidget* parent = nullptr);
  /// The row's label: "x" or "q1"; "x y z" or "q1–q3" of all axes.
  void setAxisName(const QString& axis);

 private:
  const GainKind& gain_;
};

}  // namespace underact::gui
