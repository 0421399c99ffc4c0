#pragma once
#include <QWidget>
#include <string>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace underact::gui {

/// The hands and the duration of each run, the start and the end of the measurement, and its status.
class MeasuringPart : public QWidget {
  Q_OBJECT
 public:
  explicit MeasuringPart(QWidget* parent = nullptr);
  std::string hand() const;       // empty: all
  std::size_t handCount() const;  // of the chosen ones
  double seconds() const;         // of each run
  void setShare(double share);
  void setBusy(bool is_busy, bool can_measure);
  void tell(const QString& sentence, bool alarm);

 signals:
  void measureAsked();
  void cancelAsked();
  void changed();  // other hands, other runs

 private:
  QComboBox* hands_;
  QSpinBox* seconds_;
  QPushButton *measure_, *cancel_;
  QProgressBar* progress_;
  QLabel* told_;
};

}  // namespace underact::gui
