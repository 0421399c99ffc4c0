#include "app/cli/lesson_try.h"

#include <filesystem>
#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/hands.h"
#include "app/cli/json_object.h"
#include "app/cli/scene_file.h"
#include "app/cli/setting_overrides.h"
#include "app/cli/shipped.h"
#include "core/base/printed.h"
#include "core/lesson/check_text.h"
#include "core/lesson/read.h"
#include "core/scene/scene_arm.h"
#include "core/system/resource_paths.h"
#include "device/lesson_attempt.h"

namespace underact::cli {
namespace {

struct TryOptions {
  std::string lesson;
  std::uint64_t step = 1;
  std::string hand;
  double seconds = 0.0;
  bool stopped = false;
  std::vector<double> answers;
  std::vector<std::string> settings;
  std::uint64_t seed = 1;
  bool json = false;
};

/// A file, or the lesson of that name that ships.
Result<std::string> lessonFile(const std::string& lesson) {
  if (std::filesystem::path(lesson).extension() == ".json" || std::filesystem::path(lesson).has_parent_path())
    return lesson;
  const Result<std::vector<std::string>> shipped = shippedLessons();
  if (!shipped) return shipped.problems();
  for (const std::string& path : shipped.value()) {
    if (std::filesystem::path(path).stem() == lesson) return path;
  }
  return lesson;
}

void printOutcome(const lesson::Step& step, const device::LessonOutcome& outcome, bool json, const Streams& streams) {
  std::vector<JsonObject> checks;
  for (std::size_t index = 0; index < step.checks.size(); ++index) {
    const lesson::CheckState& state = outcome.states[index];
    const std::string given = describeCheck(step.checks[index], state);
    if (!json) streams.out << (state.solved ? "solved   " : "missing  ") << printed(given) << '\n';
    JsonObject& object = checks.emplace_back();
    object.addBool("solved", state.solved);
    object.addText("said", given);
  }
  if (json) {
    JsonObject object;
    object.addBool("solved", outcome.isSolved());
    object.addList("checks", checks);
    streams.out << object.text() << '\n';
  }
  if (outcome.fault.kind != FaultKind::None) streams.err << describe(outcome.fault) << '\n';
}

Exit tryStep(const TryOptions& options, const Streams& streams) {
  const Result<std::string> file = lessonFile(options.lesson);
  if (!file) return fail(file.problems(), Exit::File, streams);
  const Result<lesson::Lesson> read = lesson::readLessonFile(file.value());
  if (!read) return fail(read.problems(), streams);
  const lesson::Lesson& lesson = read.value();
  if (options.step < 1 || options.step > lesson.steps.size()) {
    streams.err << "--step: the lesson has the steps 1 to " << lesson.steps.size() << ".\n";
    return Exit::Usage;
  }
  device::LessonAttempt attempt;
  for (const std::string& text : options.settings) {
    const auto [key, value] = sidesOf(text);
    attempt.settings.push_back({key, value});
  }
  Result<sim::HandScript> hand = findHand(options.hand, options.seed);
  if (!hand) return fail(hand.problems(), exitOfHand(options.hand, hand.problems()), streams);
  attempt.hand = std::move(hand).value();
  attempt.seconds = options.seconds, attempt.answers = options.answers, attempt.starts = !options.stopped;
  const Result<std::string> scenes = system::findResource(system::Resource::Scenes);
  if (!scenes && namesShippedScene(lesson)) return fail(scenes.problems(), Exit::File, streams);
  Result<LoadedScene> scene =
      loadScene(lesson::sceneFileOf(lesson, options.step - 1, scenes ? scenes.value() : std::string()), streams);
  if (!scene) return fail(scene.problems(), streams);
  const lesson::Step& step = lesson.steps[options.step - 1];
  attempt.hand = sim::madeFor(scene::armOf(scene.value().description), std::move(attempt.hand));
  const Result<device::LessonOutcome> outcome = tryLessonStep(step, std::move(scene.value().description), attempt);
  if (!outcome) return fail(outcome.problems(), streams);
  printOutcome(step, outcome.value(), options.json, streams);
  if (outcome.value().fault.kind != FaultKind::None) return Exit::Fault;
  return outcome.value().isSolved() ? Exit::Success : Exit::BadInput;
}

}  // namespace

void addLessonTry(Command command, const Streams& streams, Exit& exit) {
  const Command trying =
      command.add("try", "Let a scripted hand do a step of a lesson, and report what is solved and what is missing");
  const auto options = std::make_shared<TryOptions>();
  trying.option("lesson", options->lesson, "Lesson file, or the name of a lesson that ships").required();
  trying.option("--step", options->step, "Number of the step, from 1").showDefault();
  trying.option("--hand", options->hand, "A built-in hand, or a hand file").required();
  trying.option("--seconds", options->seconds, "Duration, s; by default 1 s more than the hand's path")
      .range(0.001, 3600.0);
  trying.flag("--stopped", options->stopped, "Keep the servo stopped: the hand moves the arm without force");
  trying
      .option("--answer", options->answers,
              "Answer to a question of the step, in order: a number, or the number of a choice")
      .oneEachTime();
  addSet(trying, options->settings,
         "Change a setting of the scene as a student would: by its key, as in kp_N_per_mm=0.8, or by its path in the "
         "file");
  trying.option("--seed", options->seed, "Seed of a built-in hand").showDefault().nonNegative();
  trying.flag("--json", options->json, "One JSON object instead of lines");
  trying.whenChosen([options, &streams, &exit] { exit = tryStep(*options, streams); });
}

}  // namespace underact::cli
