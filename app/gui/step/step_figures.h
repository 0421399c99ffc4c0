#pragma once
#include <QWidget>

#include "core/lab/arm_model.h"
#include "core/lab/transfer_function.h"

class QLabel;

namespace underact::gui {

class NumberTable;
struct StepPicture;

/// A response in numbers: its metrics (model, measured, fitted), and below them its poles.
class StepFigures : public QWidget {
  Q_OBJECT
 public:
  explicit StepFigures(QWidget* parent = nullptr);
  /// motion: natural frequency and damping ratio of the first response.
  void present(const StepPicture& picture, const lab::NaturalMotion& motion);

 private:
  NumberTable* table_;
  QLabel* poles_;
};

}  // namespace underact::gui
