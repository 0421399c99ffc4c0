#pragma once
#include <QElapsedTimer>
#include <QSlider>
#include <QWidget>
#include <optional>

#include "app/gui/kit/focus_wheel.h"

class QDoubleSpinBox;
class QGridLayout;
class QLabel;

namespace underact::gui {

/// What a row shows: a number from 0 up, in its unit.
struct ValueKind {
  QString tip;   // one sentence and its equation
  QString unit;  // empty: a plain number
  int steps_per_unit = 1;
  int slider_steps = 100;  // from 0 to the slider's end; up to most can be typed
  int decimals = 0;
  double max = 1.0;
  QString mark = {};  // the meaning of the mark on the slider, in a sentence; empty: the scene's own value
};

/// A slider that marks the scene's own value; a double click requests it.
class MarkedSlider : public FocusWheel<QSlider> {
  Q_OBJECT
 public:
  explicit MarkedSlider(QWidget* parent = nullptr) : FocusWheel(Qt::Horizontal, parent) {}
  void setMark(double position);  // outside the range: none
 signals:
  void resetAsked();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  double mark_ = -1.0;
};

/// A number that is changed while the hand is on the stylus: its name, a slider, and a field with its unit.
class ValueRow : public QWidget {
  Q_OBJECT
 public:
  /// name: of the object; its parts are named NAME.slider and NAME.number.
  ValueRow(const ValueKind& kind, const QString& name, QWidget* parent = nullptr);
  /// own: the scene's value; none: no mark and nothing to restore. A drag of the slider wins over the echo of its own
  /// command.
  void present(double value, const std::optional<double>& own);
  /// widest: the longest label used here or in a row above or below, so that the sliders line up.
  void setLabel(const QString& label, const QString& spoken, const QString& widest);
  /// Captions below the slider's two ends.
  void setEnds(const QString& min, const QString& max);
  /// Shows the row in amber, with the reason; empty: normal.
  void setWarning(const QString& reason);
  bool isHeld() const { return slider_->isSliderDown(); }

 signals:
  /// fresh: the first change of a drag, or of a series of keys or wheel steps.
  void changed(double value, bool fresh);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void send(double value);

  ValueKind kind_;
  QGridLayout* grid_;
  QLabel* label_;
  MarkedSlider* slider_;
  QDoubleSpinBox* number_;
  std::optional<double> own_;
  bool new_drag_ = true;
  QElapsedTimer since_last_;
};

}  // namespace underact::gui
