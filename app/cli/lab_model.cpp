#include <memory>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/lab_inputs.h"
#include "app/cli/progress.h"
#include "app/cli/scene_file.h"
#include "app/cli/table.h"
#include "core/system/signals.h"
#include "core/tradeoff/model.h"

namespace underact::cli {
namespace {

struct ModelOptions {
  std::vector<std::string> scenes;
  std::string hand = "sweep";
  double seconds = 4.0;
  bool json = false;
};

Table::Field fieldOf(const std::optional<double>& number) {
  return number ? Table::Field(*number) : Table::Field();
}

/// One row per quantity, and one for each of the three whole ticks.
void addModel(const std::string& scene, const tradeoff::Model& model, Table& table) {
  const auto add = [&](const char* key, const char* what, bool required, const std::optional<double>& ns) {
    table.add({scene, std::string(key), std::string(what), required, fieldOf(ns)});
  };
  add("bare", "position, targets and P laws alone", true, model.bare_ns);
  for (const tradeoff::Quantity& one : model.quantities) add(one.key, one.what, one.required, one.adds_ns);
  add("as_it_is", "the tick that the scene compiles to", true, model.as_it_is_ns);
  add("everything", "a tick that computes all of it", false, model.everything_ns);
  add("saved", "what computing only what is required saves", true, model.everything_ns - model.as_it_is_ns);
}

Exit models(const ModelOptions& options, const Streams& streams) {
  Exit exit = Exit::Success;
  const auto hands = labHands({options.hand}, 1, streams, exit);
  if (!hands) return exit;
  const auto scenes = labScenes(options.scenes, streams, exit);
  if (!scenes) return exit;
  const system::Interrupt interrupt;
  Progress progress(streams);
  Table table{{"scene", "quantity", "what", "required", "ns"}};
  for (std::size_t index = 0; index < scenes->size() && !interrupt.came(); ++index) {
    const tradeoff::NamedScene& scene = (*scenes)[index];
    const Result<tradeoff::Model> model =
        tradeoff::modelOf(tradeoff::benchOf(scene.scene, hands->front().hand, options.seconds));
    if (!model) return fail(model.problems(), streams);
    addModel(scene.name, model.value(), table);
    progress.show(static_cast<double>(index + 1) / static_cast<double>(scenes->size()));
  }
  options.json ? table.printJson(streams.out) : table.printCsv(streams.out);
  return Exit::Success;
}

}  // namespace

void addLabModel(Command lab, const Streams& streams, Exit& exit) {
  auto options = std::make_shared<ModelOptions>();
  const Command command = lab.add(
      "model",
      "What each scene requires of a tick, what each quantity costs, and what computing all of them would cost");
  command.option("SCENES", options->scenes, "Scene files; by default those that ship");
  command.option("--hand", options->hand, "The hand along whose path it is measured").showDefault();
  command.option("--seconds", options->seconds, "Duration of that path, s").range(0.1, 60.0).showDefault();
  command.flag("--json", options->json, "One JSON object per row instead of CSV");
  command.footer(
      "Times in ns are medians of single ticks on this machine; the time of a quantity is what it adds to the minimal "
      "tick.");
  command.whenChosen([options, &streams, &exit] { exit = models(*options, streams); });
}

}  // namespace underact::cli
