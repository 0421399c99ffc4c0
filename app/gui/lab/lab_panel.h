#pragma once
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/feature/panel.h"
#include "app/gui/lab/lab_run.h"

class QLabel;

namespace underact::gui {

class ChoiceList;
class MeasuringPart;
class WalkPart;

/// Cost and error of the scene's choices between speed and accuracy, measured in the background, and a slider along the
/// front of the combinations.
class LabPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    Actions& actions;
    ServoRate& rate;
    ArmInUse& arm_in_use;
  };
  LabPanel(const Parts& parts, QWidget* parent);
  ~LabPanel() override;
  void present(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;

 private:
  void build();
  void addCommands();

  // Measuring.
  bool measure(const std::string& hand, double seconds);  // hand: empty for all
  bool cancel();
  void pollRun();
  void end(LabResult result);
  void forget(const QString& why);
  bool hasTriedRate() const;
  void sceneOpened();
  void sceneEdited();
  /// Whether the scene is the one that was measured, apart from what the Lab itself may change.
  bool isMeasuredScene(const LabOrder& order) const;

  // Walking.
  bool walkTo(int stop, bool rate_too);
  bool putBack();
  bool setRate(int rate_hz);
  Problems setScene(const scene::Description& scene);
  void beginGesture();
  std::size_t pointAt(int stop) const { return front_[static_cast<std::size_t>(stop)]; }
  tradeoff::Settings now() const;
  /// Index into the points; none: the current settings are not among them.
  std::optional<std::size_t> pointInEffect() const;

  void refresh();
  void refreshTick();
  void refreshWalk();
  void armChanged();
  QString armText() const;
  QString measuringText() const;
  QString measuredText() const;
  QString differencesText() const;
  QString wordsOf(const std::optional<std::size_t>& chosen) const;

  Parts parts_;
  std::unique_ptr<Background<LabResult>> run_;
  LabOrder order_;                  // that is being measured, or was
  LabResult result_;                // empty: not measured
  std::vector<std::size_t> front_;  // of the points, the cheapest first: the slider's stops
  bool stale_ = false;
  int gesture_ = 0;
  QTimer poll_timer_;

  MeasuringPart* measuring_ = nullptr;
  WalkPart* walk_ = nullptr;
  QLabel* tick_ = nullptr;
  ChoiceList* choices_ = nullptr;
};

}  // namespace underact::gui
