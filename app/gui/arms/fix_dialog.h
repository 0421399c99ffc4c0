#pragma once
#include <QDialog>
#include <vector>

#include "device/driver.h"

namespace underact::gui {

/// What an arm lacks, each with the command that fixes it, to be copied into a terminal: the program itself changes
/// nothing in the system.
class FixDialog : public QDialog {
  Q_OBJECT
 public:
  FixDialog(const QString& arm, const std::vector<device::Missing>& missing, QWidget* parent);
};

}  // namespace underact::gui
