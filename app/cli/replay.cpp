#include "core/record/replay.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/progress.h"
#include "app/cli/recording.h"
#include "app/cli/scene_file.h"
#include "app/cli/setting_overrides.h"
#include "app/cli/verified_answer.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/record/csv.h"
#include "core/record/tick_figures.h"
#include "core/scene/compile.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/scene/settings.h"
#include "core/system/signals.h"

namespace underact::cli {
namespace {

struct ReplayOptions {
  std::string file, scene, record;
  std::vector<std::string> files_in, settings;
  bool verify = false, overwrite = false;
  std::optional<double> kp_N_per_mm, kd_N_s_per_mm, ki_N_per_mm_s, t;
  std::optional<std::size_t> law;  // index among the words
  system::Existing existing() const { return overwrite ? system::Existing::Replace : system::Existing::Refuse; }
  bool isWhatIf() const { return !scene.empty() || !overridesFor({}).empty() || t; }
  /// Each option that stands for a setting, then those of --set. An influence is set only if the scene has one.
  std::vector<std::string> overridesFor(const scene::Description& scene) const;
};

std::vector<std::string> ReplayOptions::overridesFor(const scene::Description& wanted) const {
  std::vector<std::string> overrides;
  const auto add = [&overrides](const char* key, const std::optional<double>& number) {
    if (number) overrides.push_back(std::string(key) + "=" + json::numberText(*number));
  };
  if (law) overrides.push_back("law=" + scene::findSetting("/control/law")->words()[*law]);
  add("kp_N_per_mm", kp_N_per_mm);
  add("kd_N_s_per_mm", kd_N_s_per_mm);
  add("ki_N_per_mm_s", ki_N_per_mm_s);
  const auto has_influence = [](const scene::Constraint& one) { return one.influence.has_value(); };
  if (std::any_of(wanted.constraints.begin(), wanted.constraints.end(), has_influence)) add("t", t);
  overrides.insert(overrides.end(), settings.begin(), settings.end());
  return overrides;
}

/// One side of the comparison.
struct Side {
  record::TickFigures figures;
  record::Work work;
  /// p_WT: of the hand, which is the recorded one on both sides.
  void add(const servo::TickRecord& record, const Vec3& p_WT) {
    figures.add(record.error_m, record.f_sent_T_W.norm());
    work.add(record.f_sent_T_W, p_WT);
  }
  JsonObject json() const {
    JsonObject object;
    object.addNumber("rms_error_mm", kMillimetrePerMetre * figures.rmsError_m());
    object.addNumber("mean_force_N", figures.meanForce_N());
    object.addNumber("peak_force_N", figures.peakForce_N());
    object.addNumber("work_mJ", kMillimetrePerMetre * work.all_J());
    return object;
  }
};

class Comparison {
 public:
  void add(const servo::TickRecord& recorded, const servo::TickRecord& now) {
    recorded_.add(recorded, recorded.p_WT);
    now_.add(now, recorded.p_WT);
    const double apart_N = (now.f_sent_T_W - recorded.f_sent_T_W).norm();
    square_apart_N2_ += apart_N * apart_N;
    max_apart_N_ = std::max(max_apart_N_, apart_N);
  }
  JsonObject json() const {
    JsonObject object;
    object.addInteger("ticks", recorded_.figures.ticks());
    object.addObject("recorded", recorded_.json());
    object.addObject("replayed", now_.json());
    JsonObject apart;
    apart.addNumber("rms_N", std::sqrt(square_apart_N2_ / static_cast<double>(recorded_.figures.ticks())));
    apart.addNumber("max_N", max_apart_N_);
    object.addObject("force_difference", apart);
    return object;
  }

 private:
  Side recorded_, now_;
  double square_apart_N2_ = 0.0, max_apart_N_ = 0.0;
};

Exit verifyTicks(record::Session& session, const ReplayOptions& options, const Streams& streams) {
  const system::Interrupt interrupt;
  Progress progress(streams);
  const auto goes_on = [&](double share) {
    progress.show(share);
    return !interrupt.came();
  };
  const Result<record::Verified> verified =
      record::verifyReplay(session, goes_on, recordedFilesFolders(options.files_in));
  if (!verified) return fail(verified.problems(), streams);
  JsonObject object;
  object.addInteger("ticks", session.info().ticks);
  object.addInteger("identical_ticks", verified.value().ticks);
  object.addBool("identical", !verified.value().differs && verified.value().unknown.empty());
  const bool same = addDifference(object, verified.value(), streams);
  streams.out << object.text() << '\n';
  return same ? Exit::Success : Exit::BadInput;
}

/// The recorded scene, or another, with the requested gains.
Result<scene::Description> wantedScene(const ReplayOptions& options, record::Session& session, const Streams& streams) {
  scene::Description scene;
  if (!options.scene.empty()) {
    Result<LoadedScene> loaded = loadScene(options.scene, streams);
    if (!loaded) return loaded.problems();
    scene = loaded.value().description;
  } else {
    if (session.changes().empty())
      return Problems{{"This session does not say which scene it began with.", {options.file}}};
    Result<scene::Description> recorded = session.scene(session.changes().front());
    if (!recorded) return recorded;
    scene = recorded.value();
    Problems unfound = scene::loadRecordedMeshes(scene, recordedFilesFolders(options.files_in));
    if (!unfound.empty()) return unfound;
  }
  Result<scene::Description> edited = withOverrides(scene, options.overridesFor(scene));
  if (!edited) return edited;
  const Problems problems = scene::check(edited.value());
  if (!problems.empty()) return problems;
  return edited;
}

Exit compare(record::Session& session, const ReplayOptions& options, const Streams& streams) {
  const Result<scene::Description> scene = wantedScene(options, session, streams);
  if (!scene) return fail(scene.problems(), streams);
  std::optional<record::CsvWriter> csv;
  if (!options.record.empty()) {
    Result<record::CsvWriter> opened = record::CsvWriter::create(options.record, options.existing());
    if (!opened) return fail(opened.problems(), Exit::File, streams);
    csv = std::move(opened).value();
  }
  const system::Interrupt interrupt;
  Progress progress(streams);
  Comparison comparison;
  const Problems problems = record::replayWith(
      session, scene.value(),
      [&](const servo::TickRecord& recorded, const servo::TickRecord& now) {
        comparison.add(recorded, now);
        if (csv) csv->add(now);
      },
      [&](double share) {
        progress.show(share);
        return !interrupt.came();
      });
  if (!problems.empty()) return fail(problems, streams);
  streams.out << comparison.json().text() << '\n';
  const Problems unwritten = csv ? csv->close() : Problems{};
  print(unwritten, streams.err);
  return unwritten.empty() ? Exit::Success : Exit::File;
}

Exit replay(const ReplayOptions& options, const Streams& streams) {
  if (options.verify && options.isWhatIf()) {
    streams.err << "--verify compares with the recorded scene; omit --scene and the gains.\n";
    return Exit::Usage;
  }
  if (const Problems problems = Recording::check(options.record, options.existing()); !problems.empty())
    return fail(problems, Exit::File, streams);
  Result<record::Session> session = record::Session::open(options.file);
  if (!session) return fail(session.problems(), streams);
  if (session.value().info().ticks == 0) {
    streams.err << "This session contains no ticks.\n";
    return Exit::BadInput;
  }
  return options.verify ? verifyTicks(session.value(), options, streams) : compare(session.value(), options, streams);
}

}  // namespace

void addReplay(Command program, const Streams& streams, Exit& exit) {
  const Command command = program.add(
      "replay", "Run a recorded hand through the tick again: bit-identical, or with other gains or another scene");
  const auto options = std::make_shared<ReplayOptions>();
  command.option("file", options->file, "Session file").required();
  command.flag("--verify", options->verify, "Compare every tick with the recording to the last bit");
  command.option("--scene", options->scene, "Another scene for the recorded hand");
  command
      .option("--files", options->files_in,
              "Folders of the recorded scene's meshes and curves, if they are not beside the session")
      .expected(1, -1)
      .word("FOLDER");
  command.option("--kp", options->kp_N_per_mm, "Another stiffness, N/mm").nonNegative();
  command.option("--kd", options->kd_N_s_per_mm, "Another damping, N s/mm").nonNegative();
  command.option("--ki", options->ki_N_per_mm_s, "Another integral gain, N/(mm s)").nonNegative();
  command.option("--t", options->t, "Another influence factor").range(0.0, 1.0);
  command.choice("--law", scene::findSetting("/control/law")->words(), options->law, "Another control law");
  addSet(command, options->settings,
         "Another value of a setting: by its path in the scene file, as in /constraints/0/friction/static=0.4, or by "
         "its key, as in kp_N_per_mm=0.1, for all constraints that have it");
  const Option recording =
      command.option("--record", options->record, "Write the ticks of the new run to this new CSV file");
  command.flag("--overwrite", options->overwrite, "Replace the file of --record if it exists").needs(recording);
  command.whenChosen([options, &streams, &exit] { exit = replay(*options, streams); });
}

}  // namespace underact::cli
