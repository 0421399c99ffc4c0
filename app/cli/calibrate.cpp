#include <memory>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/scene_file.h"
#include "core/calibration/measurement.h"
#include "device/simulated_subject.h"

namespace underact::cli {
namespace {

struct CalibrateOptions {
  std::string scene;
  double weber = 0.15;
  std::uint64_t seed = 1;
};

JsonObject rowOf(const calibration::Answered& one) {
  JsonObject row;
  row.addNumber("difference", one.trial.difference);
  row.addText("stiffer", name(one.trial.stiffer));
  row.addText("answer", name(one.answer));
  row.addBool("right", one.isRight());
  return row;
}

JsonObject summaryOf(const calibration::Measurement& run, const CalibrateOptions& options) {
  JsonObject summary;
  std::vector<JsonObject> rows;
  for (const calibration::Answered& one : run.answers) rows.push_back(rowOf(one));
  const auto threshold = calibration::thresholdOf(run.staircase);
  const auto add = [&](const char* key, double calibration::Threshold::*number) {
    threshold ? summary.addNumber(key, (*threshold).*number) : summary.addNull(key);
  };
  add("threshold", &calibration::Threshold::difference);
  add("low", &calibration::Threshold::low);
  add("high", &calibration::Threshold::high);
  summary.addNumber("reference_N_per_mm", run.reference_N_per_mm);
  summary.addNumber("weber", options.weber);
  summary.addInteger("seed", options.seed);
  summary.addList("reversals", run.staircase.reversals);
  summary.addList("trials", rows);
  return summary;
}

Exit calibrate(const CalibrateOptions& options, const Streams& streams) {
  const Result<LoadedScene> loaded = loadScene(options.scene, streams);
  if (!loaded) return fail(loaded.problems(), streams);
  const Result<double> reference = calibration::softerOf(loaded.value().description);
  if (!reference) return fail(reference.problems(), Exit::BadInput, streams);
  calibration::Measurement run = calibration::beginMeasurement(reference.value(), options.seed);
  device::SimulatedSubject subject{options.weber, options.seed + 1};
  while (!isDone(run)) {
    const auto scene = withStiffness(loaded.value().description, run.trial);
    if (!scene) return fail(scene.problems(), Exit::BadInput, streams);
    const auto answer = device::answerOf(subject, scene.value());
    if (!answer) return fail(answer.problems(), Exit::BadInput, streams);
    run = answered(std::move(run), answer.value());
  }
  streams.out << summaryOf(run, options).text() << '\n';
  return Exit::Success;
}

}  // namespace

void addCalibrate(Command program, const Streams& streams, Exit& exit) {
  const Command command = program.add(
      "calibrate",
      "Measure the just-noticeable difference of stiffness of a simulated hand, by a two-alternative staircase");
  const auto options = std::make_shared<CalibrateOptions>();
  command.option("scene", options->scene, "A scene with two beams").required();
  command.option("--weber", options->weber, "Scatter of what the hand feels, as a fraction")
      .showDefault()
      .range(0.0, 1.0);
  command.option("--seed", options->seed, "Seed of everything that is random").showDefault().nonNegative();
  command.footer(
      "One JSON object out: \"threshold\", the just-noticeable difference as a fraction (2 right in a row make it "
      "harder: 70.7 % right),\n"
      "\"low\" and \"high\", one standard deviation to either side, \"reversals\" and \"trials\".");
  command.whenChosen([options, &streams, &exit] { exit = calibrate(*options, streams); });
}

}  // namespace underact::cli
