#pragma once
#include <QObject>
#include <QString>

#include "core/sim/arm_model_file.h"

namespace underact::device {
class SimulatedArm;
}

namespace underact::gui {

/// The model of the window's simulated arm: the vendor's figures, or those of a measured arm.
class ArmInUse : public QObject {
  Q_OBJECT
 public:
  /// arm: null if a real one is in use; the model then has no effect. remembered: as returned by text().
  ArmInUse(device::SimulatedArm* arm, const QString& remembered, QObject* parent);

  const sim::ArmModel& model() const { return file_.arm; }
  bool isMeasured() const { return is_measured_; }
  bool hasSimulatedArm() const { return arm_ != nullptr; }
  /// Loads a model from a file. Problems: of the file; the arm stays as it is.
  Problems open(const QString& path);
  void use(const sim::ArmModelFile& file);
  void useVendors();
  /// To be saved for the next start; empty: the vendor's figures.
  QString text() const;

 signals:
  void changed();

 private:
  void put();
  device::SimulatedArm* arm_;
  sim::ArmModelFile file_;
  bool is_measured_ = false;
};

}  // namespace underact::gui
