#pragma once
#include <QWidget>
#include <string>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace underact::gui {

/// Who holds the stylus and for how long, the measurement's begin and end, and what there is to know of it.
class MeasuringPart : public QWidget {
  Q_OBJECT
 public:
  explicit MeasuringPart(QWidget* parent = nullptr);
  std::string hand() const;       // empty: all
  std::size_t handCount() const;  // of those that are chosen
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
