#include "app/gui/servo/check_run.h"

#include <chrono>

#include "app/gui/model/simulated_host.h"
#include "core/scene/compile.h"

namespace underact::gui {
namespace {

/// The sphere of the first start: the tip rests on it, and a tick does typical work.
tick::TickProgram program() {
  scene::Description scene;
  scene.title = "Check";
  scene.constraints.push_back({"sphere", scene::Sphere{Vec3::Zero(), 50.0}, target::Side::Both, {}, {}});
  return scene::compile(scene).value();
}

}  // namespace

CheckRun::CheckRun(const servo::CheckOptions& options)
    : result_(std::async(std::launch::async, [this, options] {
        device::SimulatedArm arm(simulatedArmOptions(options.rate_hz));
        return servo::checkServo(arm, program(), options, [this](double share) {
          share_ = share;
          return !cancelled_;
        });
      })) {}

CheckRun::~CheckRun() {
  cancel();
  if (result_.valid()) result_.wait();
}

std::optional<servo::CheckResult> CheckRun::takeResult() {
  if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
  return result_.get();
}

}  // namespace underact::gui
