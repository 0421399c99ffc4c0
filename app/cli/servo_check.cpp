#include <array>
#include <cmath>
#include <iomanip>
#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/arm_choice.h"
#include "app/cli/command.h"
#include "app/cli/run_summary.h"
#include "app/cli/scene_file.h"
#include "app/options/scheduling_options.h"
#include "core/arm/preset.h"
#include "core/scene/compile.h"
#include "core/scene/scene_arm.h"
#include "core/servo/check.h"
#include "core/sim/arm_model_file.h"
#include "core/sim/hand_script.h"
#include "core/system/signals.h"
#include "device/simulated_arm.h"

namespace underact::cli {
namespace {

constexpr int kLongestCheck_s = 86'400;

struct ServoCheckOptions {
  servo::CheckOptions check;
  std::string scene;  // empty: defaultScene()
  std::string arm_model{sim::kDefaultArmModel};
  bool json = false;
};

scene::Description defaultScene() {
  scene::Description scene;
  scene.title = "Sphere";
  scene.constraints.push_back({"sphere", scene::Sphere{Vec3::Zero(), 50.0}, target::Side::Both, {}, {}});
  return scene;
}

Result<LoadedScene> sceneOf(const ServoCheckOptions& options, const Streams& streams) {
  if (!options.scene.empty()) return loadScene(options.scene, streams);
  LoadedScene loaded{defaultScene(), {}};
  Result<tick::TickProgram> program = scene::compile(loaded.description);
  if (!program) return program.problems();
  loaded.program = std::move(program).value();
  return loaded;
}

device::SimulatedArm::Options armOf(const ServoCheckOptions& options, const sim::ArmModel& model,
                                    const scene::Description& scene, const sim::HandScript& hand) {
  device::SimulatedArm::Options arm;
  arm.arm = scene::armOf(scene);
  arm.model = model;
  arm.integration = integrationOf(scene.simulation);
  arm.hand = hand.hand;
  arm.rate_hz = options.check.rate_hz;
  return arm;
}

JsonObject lateObject(const servo::LateTicks& late) {
  JsonObject object;
  for (std::size_t cause = 0; cause < servo::kLateCauses; ++cause) {
    object.addInteger(servo::name(static_cast<servo::LateCause>(cause)), late.by_cause[cause]);
  }
  return object;
}

JsonObject checkObject(const servo::CheckResult& result, const ServoCheckOptions& options) {
  JsonObject object;
  object.addObject("floor_us", percentilesObject(result.floor));
  object.addObject("servo_us", percentilesObject(result.servo));
  object.addObject("tick_us", percentilesObject(result.tick_time));
  object.addText("scheduling", result.scheduling.name);
  object.addTexts("scheduling_also", {result.scheduling.also.begin(), result.scheduling.also.end()});
  object.addText("hint", result.scheduling.hint);
  object.addInteger("late_ticks", result.late.total);
  object.addObject("late_ticks_by_cause", lateObject(result.late));
  object.addInteger("left_out_ticks", result.late.left_out);
  object.addInteger("ticks", result.ticks);
  object.addInteger("rate_hz", options.check.rate_hz);
  object.addNumber("seconds", result.seconds);
  object.addBool("load", options.check.load);
  return object;
}

void printPercentiles(std::ostream& out, const char* name, const servo::Percentiles& values) {
  out << std::left << std::setw(26) << name << std::right << std::fixed << std::setprecision(1);
  for (const double value_us : {values.p50_us, values.p99_us, values.p999_us, values.max_us}) {
    out << std::setw(11) << value_us;
  }
  out << '\n';
}

void printRatios(std::ostream& out, const servo::CheckResult& result) {
  out << std::left << std::setw(26) << "servo / bare loop" << std::right << std::fixed << std::setprecision(2)
      << std::setw(22) << result.servo.p99_us / result.floor.p99_us << std::setw(11)
      << result.servo.p999_us / result.floor.p999_us << '\n';
}

void printCheck(std::ostream& out, const servo::CheckResult& result, const ServoCheckOptions& options) {
  out << "Scheduling: " << result.scheduling.name;
  for (const std::string& phrase : result.scheduling.also) out << ", " << phrase;
  out << '\n'
      << result.ticks << " ticks at " << options.check.rate_hz << " Hz, in " << std::fixed << std::setprecision(1)
      << result.seconds << " s shared with a bare loop" << (options.check.load ? ", every core kept busy" : "")
      << "\n\n";
  out << std::left << std::setw(26) << "us" << std::right;
  for (const char* column : {"p50", "p99", "p99.9", "max"}) out << std::setw(11) << column;
  out << '\n';
  printPercentiles(out, "latency of a bare loop", result.floor);
  printPercentiles(out, "latency of the servo", result.servo);
  printRatios(out, result);
  printPercentiles(out, "duration of a tick", result.tick_time);
  out << "\nA period or more late: " << result.late.total;
  const char* separator = " (";
  for (std::size_t cause = 0; cause < servo::kLateCauses; ++cause) {
    if (result.late.by_cause[cause] == 0) continue;
    out << separator << servo::name(static_cast<servo::LateCause>(cause)) << ' ' << result.late.by_cause[cause];
    separator = ", ";
  }
  out << (result.late.total > 0 ? ")" : "") << "; left out: " << result.late.left_out << '\n';
}

/// progress for checkServo(): prints it, and ends the check on Ctrl+C.
std::function<bool(double)> reporter(const Streams& streams, const system::Interrupt& interrupt) {
  return [&streams, &interrupt, shown_percent = -1](double share) mutable {
    const int percent = static_cast<int>(100.0 * share);
    if (streams.progress && percent != shown_percent) {
      shown_percent = percent;
      streams.err << '\r' << percent << " %" << (share >= 1.0 ? "\n" : "") << std::flush;
    }
    return !interrupt.came();
  };
}

Exit runCheck(const ServoCheckOptions& options, const Streams& streams) {
  Result<LoadedScene> scene = sceneOf(options, streams);
  if (!scene) return fail(scene.problems(), streams);
  const Result<sim::ArmModel> model = sim::chooseArmModel(options.arm_model);
  if (!model) return fail(model.problems(), streams);
  sim::HandScript hand = sim::builtInHand("sweep", 1).value();
  device::SimulatedArm arm(armOf(options, model.value(), scene.value().description, hand));
  arm.follow(std::move(hand));
  const system::Interrupt interrupt;
  const servo::CheckResult result =
      servo::checkServo(arm, std::move(scene.value().program), options.check, reporter(streams, interrupt));
  if (options.json) {
    streams.out << checkObject(result, options).text() << '\n';
    return Exit::Success;
  }
  printCheck(streams.out, result, options);
  if (!result.scheduling.hint.empty()) streams.err << result.scheduling.hint << '\n';
  return Exit::Success;
}

}  // namespace

void addServoCheck(Command program, const Streams& streams, Exit& exit) {
  const Command command = program.add(
      "servo-check", "Measure the latency of the servo, compared with the least that this machine can achieve");
  const auto options = std::make_shared<ServoCheckOptions>();
  command.option("--seconds", options->check.seconds, "Total duration, s; half of it for a bare loop")
      .showDefault()
      .range(1, kLongestCheck_s);
  command.option("--rate", options->check.rate_hz, "Ticks per second").showDefault().range(100, 10000);
  command.flag("--load", options->check.load, "Keep every core busy meanwhile");
  command.option("--scene", options->scene, "Scene file; by default a sphere");
  addArmModelOption(command, options->arm_model);
  options::addSchedulingOptions(command, options->check.scheduling);
  command.flag("--json", options->json, "One JSON object instead of the table");
  command.whenChosen([options, &streams, &exit] { exit = runCheck(*options, streams); });
}

}  // namespace underact::cli
