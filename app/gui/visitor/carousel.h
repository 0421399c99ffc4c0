#pragma once

namespace underact::gui {

/// Decides when the next scene is due and when a visitor has left. Pure: time is passed in, from the servo's ticks.
class Carousel {
 public:
  enum class Step { Stay, Next, Reset };

  /// Another scene is now shown.
  void showed(double time_s) { scene_s_ = time_s; }
  /// touched: somebody moves the hand or has pressed a button. Reset: once for each visitor who has left.
  Step at(double time_s, bool touched);
  void setDwell(double dwell_s) { dwell_s_ = dwell_s; }
  double dwell_s() const { return dwell_s_; }

  static constexpr double kAlone_s = 60.0;

 private:
  double dwell_s_ = 90.0, scene_s_ = 0.0, touched_s_ = 0.0;
  bool has_visitor_ = false;
};

}  // namespace underact::gui
