#pragma once
#include <QWidget>

#include "core/lesson/check.h"

class QButtonGroup;
class QLabel;
class QLineEdit;

namespace underact::gui {

/// One check of a step: its question, if it has one, with the fields that answer it, and a line that says what was done
/// and what is missing.
class CheckRow : public QWidget {
  Q_OBJECT
 public:
  /// number: of the check in its step, from 1.
  CheckRow(const lesson::Check& check, std::size_t number, QWidget* parent);
  void present(const lesson::Check& check, const lesson::CheckState& state);

 signals:
  void answered(double answer);

 private:
  void addNumber(const lesson::AskNumber& ask);
  void addChoices(const lesson::AskChoice& ask);
  void give();

  QString name_;  // prefix of the object names in it
  QLabel* message_;
  QLineEdit* number_ = nullptr;
  QButtonGroup* choices_ = nullptr;
};

}  // namespace underact::gui
