#include "app/gui/model/arm_in_use.h"

#include "device/simulated_arm.h"

namespace underact::gui {
namespace {

sim::ArmModelFile vendors() {
  sim::ArmModelFile file;
  file.arm = *sim::findArmModel(sim::kDefaultArmModel);
  return file;
}

}  // namespace

ArmInUse::ArmInUse(device::SimulatedArm* arm, const QString& remembered, QObject* parent)
    : QObject(parent), arm_(arm), file_(vendors()) {
  if (remembered.isEmpty()) return;
  Result<sim::ArmModelFile> read = sim::readArmModel(remembered.toStdString(), "settings");
  if (read) use(read.value());  // else it is of another version: use the vendor's figures
}

Problems ArmInUse::open(const QString& path) {
  Result<sim::ArmModelFile> read = sim::readArmModelFile(path.toStdString());
  if (!read) return read.problems();
  use(read.value());
  return {};
}

void ArmInUse::use(const sim::ArmModelFile& file) {
  file_ = file;
  is_measured_ = true;
  put();
}

void ArmInUse::useVendors() {
  file_ = vendors();
  is_measured_ = false;
  put();
}

void ArmInUse::put() {
  if (arm_ != nullptr) arm_->become(file_.arm);
  emit changed();
}

QString ArmInUse::text() const {
  return is_measured_ ? QString::fromStdString(sim::armModelText(file_)) : QString();
}

}  // namespace underact::gui
