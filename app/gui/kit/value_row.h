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

/// What a row shows: a number from 0 on, in its unit.
struct ValueKind {
  QString tip;   // one sentence and the equation it stands for
  QString unit;  // empty: a plain number
  int steps_per_unit = 1;
  int slider_steps = 100;  // from 0 to the slider's end; typing goes on to most
  int decimals = 0;
  double most = 1.0;
  QString mark = {};  // what the mark on the slider is, in a sentence; empty: the scene's own value
};

/// A slider that marks the scene's own value; a double click asks for it back.
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

/// One number that is changed while the hand is on the stylus: its name, a slider, a field with its unit.
class ValueRow : public QWidget {
  Q_OBJECT
 public:
  /// name: of the object; its parts are NAME.slider and NAME.number.
  ValueRow(const ValueKind& kind, const QString& name, QWidget* parent = nullptr);
  /// own: the scene's value; none: nothing is marked, nothing to go back to. The hand on the slider wins over the echo
  /// of its own command.
  void present(double value, const std::optional<double>& own);
  /// widest: the longest label that ever stands here, or in a row above or below, so that the sliders stay in line.
  void setLabel(const QString& label, const QString& spoken, const QString& widest);
  /// Words below the slider's two ends.
  void setEnds(const QString& least, const QString& most);
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
