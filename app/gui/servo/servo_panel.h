#pragma once
#include <QElapsedTimer>
#include <QPointer>

#include "app/gui/feature/panel.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace underact::gui {

class CheckDialog;
class LimitsSection;
class RateChooser;
class SchedulingSection;
class TimeSection;

/// Limits, time and scheduling of the servo, its rate, and hold to run.
class ServoPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    ServoFacts servo;
    ServoControl control;
    Actions& actions;
    ServoRate& rate;
    ArmChoice& arms;
    const Settings& settings;
  };
  ServoPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;
  void remember(Settings& settings) override;
  void add(const servo::TickRecord& record) override;
  void setTheme(const Theme& theme) override;

 private:
  void addActions();
  void buildSwitches(QVBoxLayout* column);
  QPushButton* buttonFor(const QString& action, const QString& words);
  bool restart();
  bool setRate(int rate_hz);
  void rateChanged(int was_hz, int is_hz);
  void tell(const QString& sentence, bool alarm);
  void measureRate(const servo::Snapshot& snapshot);

  Parts parts_;
  TimeSection* time_;
  SchedulingSection* scheduling_;
  LimitsSection* limits_;
  RateChooser* rate_ = nullptr;
  QLabel* told_ = nullptr;  // the result of a restart or of a rate change
  QPointer<CheckDialog> check_;
  QElapsedTimer since_measured_;
  std::int64_t ticks_at_measure_ = 0;
  std::int64_t shown_ticks_ = -1;
  double measured_hz_ = kNotANumber;  // not measured yet
};

}  // namespace underact::gui
