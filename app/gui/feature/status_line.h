#pragma once
#include <QElapsedTimer>
#include <QWidget>

#include "app/gui/model/servo_facts.h"

class QLabel;

namespace underact::gui {

/// The line at the bottom, always true: what the servo does, which arm, how fast, how late, how it is scheduled, which
/// force.
class StatusLine : public QWidget {
  Q_OBJECT
 public:
  StatusLine(ServoFacts servo, double force_limit_N, QWidget* parent = nullptr);
  void present(const servo::Snapshot& snapshot);
  /// What the thing under the pointer does; empty: nothing.
  void setTip(const QString& tip);
  /// The sentence of the fault that stopped the servo; empty: none.
  void setFault(const QString& sentence);
  /// What is being recorded; empty: nothing is. needs_a_look: it should be seen to; tip: why.
  void setRecording(const QString& words, const QString& tip, bool needs_a_look);
  /// The rate is another one: what was measured of the one before says nothing of it.
  void measureAnew() { since_measured_.invalidate(); }
  /// Another arm, or none: after a replay has begun or ended.
  void presentDevice(bool is_recorded = false);
  /// What the simulated arm is made of: its name beside the arm's (empty: nothing is said), and where its figures come
  /// from.
  void setArmModel(const QString& name, const QString& provenance);
  void setForceLimit(double limit_N) { force_limit_N_ = limit_N; }
  /// Where live data goes ("live data to 127.0.0.1:9870"), and more of it for a tool tip; empty: nowhere.
  void setLive(const QString& where, const QString& details);

 private:
  QLabel* field(const char* name, const QString& spoken, const QString& tip, const QString& widest);
  void presentMode(const servo::Snapshot& snapshot);
  void presentRate(const servo::Snapshot& snapshot);
  void presentScheduling();
  void presentGuard();

  ServoFacts servo_;
  double force_limit_N_;
  QLabel *mode_, *device_, *rate_, *late_, *scheduling_, *guard_, *force_, *recording_, *live_, *tip_;
  QElapsedTimer since_measured_;
  std::int64_t ticks_at_measure_ = 0;
  QString arm_model_, provenance_;
  bool is_recorded_ = false;
};

}  // namespace underact::gui
