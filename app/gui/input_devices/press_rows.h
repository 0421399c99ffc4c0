#pragma once
#include <QWidget>
#include <array>

#include "device/input/motion.h"

class QComboBox;
class QPushButton;

namespace underact::gui {

struct InputDeviceEntry;

/// The buttons of a mapping: a row for each, with a choice and a button to learn it.
class PressRows : public QWidget {
  Q_OBJECT
 public:
  explicit PressRows(QWidget* parent);
  void present(const InputDeviceEntry& entry);
  /// learning: the field that is being learnt.
  void presentLearning(const QString& learning);

 signals:
  void chosen(const QString& field, const QVariant& button);
  void learnAsked(const QString& field);

 private:
  std::array<QComboBox*, device::input::kPresses> presses_{};
  std::array<QPushButton*, device::input::kPresses> learns_{};
};

}  // namespace underact::gui
