#pragma once
#include <QElapsedTimer>
#include <QSlider>
#include <QWidget>

class QDoubleSpinBox;
class QLabel;

namespace underact::gui {

/// One of the three gains of a law, as the window shows it.
struct GainKind {
  const char* key;   // "kp"
  const char* name;  // "Stiffness"
  const char* tip;   // one sentence and the equation it stands for
  const char* unit;
  int steps_per_unit;  // of the slider and the arrows
  int slider_steps;    // from 0 to the slider's end; typing goes beyond
  int decimals;
};

inline constexpr int kGainKinds = 3;
const GainKind& gainKind(int gain);  // 0 kp, 1 kd, 2 ki

/// A slider that marks the scene's own value; a double click asks for it back.
class MarkedSlider : public QSlider {
  Q_OBJECT
 public:
  explicit MarkedSlider(QWidget* parent = nullptr) : QSlider(Qt::Horizontal, parent) {}
  void setMark(double position);
 signals:
  void resetAsked();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  double mark_ = 0.0;
};

/// One gain of one axis (or joint): its name, a slider, a number with its unit.
class GainRow : public QWidget {
  Q_OBJECT
 public:
  GainRow(int gain, int axis, QWidget* parent = nullptr);
  /// own: the scene's value. The hand on the slider wins over the echo of its own command.
  void present(double value, double own);
  /// What the row is called: "x", or "q1".
  void setAxisName(const QString& axis);
  /// Amber, with the reason; empty: calm.
  void setWarning(const QString& reason);
  bool isHeld() const { return slider_->isSliderDown(); }

 signals:
  /// fresh: the first change of a drag, or of a run of keys or wheel steps.
  void changed(double value, bool fresh);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void send(double value);

  const GainKind& kind_;
  QLabel* label_;
  MarkedSlider* slider_;
  QDoubleSpinBox* number_;
  double own_ = 0.0;
  bool new_drag_ = true;
  QElapsedTimer since_last_;
};

}  // namespace underact::gui
