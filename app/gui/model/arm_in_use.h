#pragma once
#include <QObject>
#include <QString>

#include "core/sim/arm_model_file.h"

namespace underact::device {
class SimulatedArm;
}

namespace underact::gui {

/// What the simulated arm of the window is made of: the vendor's figures, or an arm that was measured.
class ArmInUse : public QObject {
  Q_OBJECT
 public:
  /// arm: null where a real one is there; then nothing is changed by a model. remembered: as text() gave it.
  ArmInUse(device::SimulatedArm* arm, const QString& remembered, QObject* parent);

  const sim::ArmModel& model() const { return file_.arm; }
  bool isMeasured() const { return is_measured_; }
  bool hasSimulatedArm() const { return arm_ != nullptr; }
  /// From a file. Problems: what is wrong with it; then the arm stays as it is.
  Problems open(const QString& path);
  void use(const sim::ArmModelFile& file);
  void useVendors();
  /// For the next life of the window; empty: the vendor's figures.
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
