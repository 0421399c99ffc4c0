#pragma once
#include <QWidget>

class QComboBox;

namespace underact::gui {

/// A choice of the common servo rates, and of the present one if it is not among them.
class RateChooser : public QWidget {
  Q_OBJECT
 public:
  explicit RateChooser(QWidget* parent = nullptr);
  void present(int rate_hz);

 signals:
  void asked(int rate_hz);

 private:
  QComboBox* box_;
  int shown_hz_ = 0;
};

}  // namespace underact::gui
