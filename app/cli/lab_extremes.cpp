#include <iomanip>
#include <memory>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/scene_file.h"
#include "core/base/units.h"
#include "core/lab/extremes.h"
#include "core/scene/scene_arm.h"

namespace underact::cli {
namespace {

struct ExtremesOptions {
  std::string scene;
  int poses = 2000, rate_hz = 1000;
  std::uint64_t seed = 1;
  bool json = false;
};

void printObject(const ExtremesOptions& options, const lab::SceneExtremes& extremes, std::ostream& out) {
  JsonObject object;
  object.addText("scene", options.scene);
  object.addInteger("poses", extremes.poses);
  object.addInteger("without_answer", extremes.without_answer);
  object.addInteger("beyond_limit", extremes.beyond_limit);
  const auto add = [&object](const std::string& key, const lab::Greatest& greatest) {
    object.addNumber(key, greatest.value);
    object.addVector(key + "_at_mm", kMillimetrePerMetre * greatest.p_WT);
  };
  add("force_N", extremes.force_N);
  add("per_ulp_N", extremes.per_ulp_N);
  add("per_encoder_step_N", extremes.per_encoder_step_N);
  object.addNumber("tick_p50_us", 1e-3 * extremes.tick.p50_ns);
  object.addNumber("tick_p99_us", 1e-3 * extremes.tick.p99_ns);
  object.addNumber("tick_max_us", 1e-3 * extremes.tick.max_ns);
  out << object.text() << '\n';
}

void printTable(const ExtremesOptions& options, const lab::SceneExtremes& extremes, std::ostream& out) {
  const auto line = [&out](const char* what, const lab::Greatest& greatest) {
    const Vec3 p_WT_mm = kMillimetrePerMetre * greatest.p_WT;
    out << std::left << std::setw(44) << what << std::right << std::setprecision(3) << std::setw(10) << greatest.value
        << " N";
    if (greatest.value > 0.0)
      out << "  tip at (" << std::fixed << std::setprecision(1) << p_WT_mm.x() << ", " << p_WT_mm.y() << ", "
          << p_WT_mm.z() << ") mm" << std::defaultfloat;
    out << '\n';
  };
  line("greatest force that the scene asks for", extremes.force_N);
  line("change of force by an encoder step", extremes.per_encoder_step_N);
  line("change of force by the last bit of an angle", extremes.per_ulp_N);
  out << "poses beyond the limit of the force          " << extremes.beyond_limit << " of " << extremes.poses << '\n';
  out << "poses without a single nearest point         " << extremes.without_answer << " of " << extremes.poses << '\n';
  out << std::setprecision(3) << "a tick on this machine: median " << 1e-3 * extremes.tick.p50_ns << " us, 99 % within "
      << 1e-3 * extremes.tick.p99_ns << " us, longest " << 1e-3 * extremes.tick.max_ns << " us; that is "
      << 1e-7 * extremes.tick.p99_ns * options.rate_hz << " % of a period at " << options.rate_hz << " Hz\n";
}

Exit extremesOf(const ExtremesOptions& options, const Streams& streams) {
  const Result<LoadedScene> loaded = loadScene(options.scene, streams);
  if (!loaded) return fail(loaded.problems(), streams);
  const lab::SceneExtremes extremes =
      lab::extremesOf(loaded.value().program, scene::armOf(loaded.value().description), options.seed, options.poses);
  (options.json ? printObject : printTable)(options, extremes, streams.out);
  return Exit::Success;
}

}  // namespace

void addLabExtremes(Command lab, const Streams& streams, Exit& exit) {
  const auto options = std::make_shared<ExtremesOptions>();
  const Command command = lab.add("extremes",
                                  "The limits of a scene on this machine: its greatest force, how finely the arm's "
                                  "encoders divide it, where it has no answer, and how long a tick takes");
  command.option("SCENE", options->scene, "A scene file").required();
  command.option("--poses", options->poses, "Poses, drawn evenly within the arm's joint limits")
      .range(1, 10'000'000)
      .showDefault();
  command.option("--rate", options->rate_hz, "Ticks per second that a tick's time is compared with")
      .range(1, 100'000)
      .showDefault();
  command.option("--seed", options->seed, "Seed of the poses").showDefault();
  command.flag("--json", options->json, "One JSON object instead of a table");
  command.whenChosen([options, &streams, &exit] { exit = extremesOf(*options, streams); });
}

}  // namespace underact::cli
