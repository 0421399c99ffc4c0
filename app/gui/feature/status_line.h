#pragma once
#include <QElapsedTimer>
#include <QWidget>

#include "app/gui/model/servo_facts.h"

class QLabel;

namespace underact::gui {

/// The line at the bottom, always up to date: state of the servo, arm, rate, latency, scheduling, force.
class StatusLine : public QWidget {
  Q_OBJECT
 public:
  StatusLine(ServoFacts servo, double force_limit_N, QWidget* parent = nullptr);
  void present(const servo::Snapshot& snapshot);
  /// The tip of the action under the pointer; empty: none.
  void setTip(const QString& tip);
  /// The sentence of the fault that stopped the servo; empty: none.
  void setFault(const QString& sentence);
  /// What is being recorded; empty: nothing. needs_a_look: it needs attention; tip: why.
  void setRecording(const QString& words, const QString& tip, bool needs_a_look);
  /// Discards what was measured at the previous rate.
  void measureAnew() { since_measured_.invalidate(); }
  /// Shows the arm, or none, after a replay has begun or ended.
  void presentDevice(bool is_recorded = false);
  /// The model of the simulated arm: its name, shown beside the arm's (empty: not shown), and the source of its
  /// figures.
  void setArmModel(const QString& name, const QString& provenance);
  void setForceLimit(double limit_N) { force_limit_N_ = limit_N; }
  /// Where live data goes ("live data to 127.0.0.1:9870"), and more of it for a tool tip; empty: nowhere.
  void setLive(const QString& where, const QString& details);

 private:
  QLabel* field(const char* name, const QString& spoken, const QString& tip, const QString& widest);
  void presentMode(const servo::Snapshot& snapshot);
  void presentDetails();
  void presentRate(const servo::Snapshot& snapshot);
  void presentScheduling();
  void presentGuard();

  ServoFacts servo_;
  double force_limit_N_;
  QLabel *mode_, *device_, *rate_, *late_, *scheduling_, *guard_, *force_, *recording_, *live_, *tip_;
  QElapsedTimer since_measured_;
  std::int64_t ticks_at_measure_ = 0;
  QString arm_model_, provenance_, fault_;
  bool is_recorded_ = false;
};

}  // namespace underact::gui
