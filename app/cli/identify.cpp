#include <algorithm>
#include <iomanip>
#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/arm_choice.h"
#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/progress.h"
#include "app/cli/scene_file.h"
#include "app/cli/step_report.h"
#include "app/cli/today.h"
#include "core/arm/preset.h"
#include "core/base/printed.h"
#include "core/base/units.h"
#include "core/identify/report.h"
#include "core/json/json.h"
#include "core/sim/arm_model_file.h"
#include "core/system/signals.h"
#include "device/measure_simulated.h"
#include "underact/version.h"

namespace underact::cli {
namespace {

struct IdentifyOptions {
  std::string arm{arm::kDefaultArm};
  std::string arm_model{sim::kDefaultArmModel};
  std::vector<double> at_mm{0.0, 0.0, 60.0};
  int rate_hz = 1000;
  std::uint64_t seed = 1;
  std::string out, report, name = "measured";
  bool json = false;
};

JsonObject rowObject(const identify::ReportRow& row) {
  JsonObject object;
  object.addText("quantity", row.quantity);
  object.addText("unit", row.unit);
  object.addNumber("value", row.estimate.value);
  object.addNumber("uncertainty", row.estimate.uncertainty);
  object.addBool("told_from_zero", row.estimate.isSignificant());
  row.given ? object.addNumber("given", *row.given) : object.addNull("given");
  return object;
}

JsonObject identifiedObject(const identify::Identified& found, const identify::Given& given) {
  JsonObject object;
  object.addText("arm", found.arm);
  object.addInteger("rate_hz", found.rate_hz);
  object.addNumber("mass_kg", found.mean_mass_kg.value);
  object.addNumber("friction_N", found.mean_friction_N.value);
  object.addNumber("damping_N_s_per_m", found.mean_damping_N_s_per_m.value);
  std::vector<JsonObject> rows;
  for (const identify::ReportRow& row : identify::rowsOf(found, &given)) rows.push_back(rowObject(row));
  object.addList("rows", rows);
  std::vector<std::string> notes;
  for (const Problem& note : found.notes) notes.push_back(note.sentence);
  object.addTexts("notes", notes);
  return object;
}

/// In columns; a character of more than one byte is one column.
void cell(std::ostream& out, const std::string& text, int width) {
  int shown = 0;
  for (const char one : text) shown += (static_cast<unsigned char>(one) & 0xC0U) != 0x80U ? 1 : 0;
  out << text << std::string(static_cast<std::size_t>(std::max(1, width - shown)), ' ');
}

void printEstimates(const identify::Identified& found, const identify::Given& given, std::ostream& out) {
  const auto line = [&out](const std::vector<std::string>& cells) {
    const int widths[] = {36, 16, 14, 8, 12, 1};
    for (std::size_t index = 0; index + 1 < cells.size(); ++index) cell(out, cells[index], widths[index]);
    out << cells.back() << '\n';
  };
  line({"", "value", "uncertainty", "unit", "given", "difference"});
  for (const identify::ReportRow& row : identify::rowsOf(found, &given)) {
    std::string was;
    if (row.given) was = json::numberText(*row.given);
    line({row.quantity, valueText(row), uncertaintyText(row), row.unit, was, differenceText(row)});
  }
}

/// Writes the requested output. Exit: Well, or File.
Exit writeFiles(const IdentifyOptions& options, const identify::Identified& found, const identify::Given& given,
                const Streams& streams) {
  sim::Provenance provenance;
  provenance.device = "the simulated arm (" + given.model.name + ")";
  provenance.date = today();
  provenance.program = std::string("underact ") + kVersion;
  const sim::ArmModelFile file =
      modelFileOf(found, options.name, "Measured " + provenance.date + " (" + options.name + ")", provenance);
  Exit exit = Exit::Success;
  for (const auto& [path, text] :
       {std::pair{options.out, sim::armModelText(file)}, std::pair{options.report, reportText(found, file, &given)}}) {
    if (path.empty()) continue;
    const Problems problems = writeText(path, text);
    print(problems, streams.err);
    if (!problems.empty()) exit = Exit::File;
  }
  return exit;
}

Exit runIdentification(const IdentifyOptions& options, const Streams& streams) {
  const arm::Preset* const preset = arm::findPreset(options.arm);
  const Result<sim::ArmModel> model = sim::chooseArmModel(options.arm_model);
  if (!model) return fail(model.problems(), streams);
  device::SimulatedArm::Options arm;
  arm.arm = *preset;
  arm.model = model.value();
  arm.rate_hz = options.rate_hz;
  identify::Wanted wanted;
  wanted.arm_of.arm = options.arm;
  wanted.places_W.clear();
  for (std::size_t at = 0; at + 2 < options.at_mm.size(); at += 3)
    wanted.places_W.push_back(kMetrePerMillimetre * Eigen::Map<const Vec3>(options.at_mm.data() + at));
  const system::Interrupt interrupt;
  Progress progress(streams);
  const auto measured = device::measureSimulated(arm, wanted, options.seed, [&](double share) {
    progress.show(share);
    return !interrupt.came();
  });
  if (!measured) return fail(measured.problems(), Exit::BadInput, streams);
  if (const Fault& fault = measured.value().fault; fault.kind != FaultKind::None) {
    print({{whatHappened(fault) + " The servo released the force, and the measurement ended. A higher rate may help."}},
          streams.err);
    return Exit::Fault;
  }
  const auto found = identify::evaluate(measured.value().plan, measured.value().recorded, options.rate_hz,
                                        [&interrupt] { return interrupt.came(); });
  if (!found) return fail(found.problems(), Exit::BadInput, streams);
  identify::Given given{model.value(), preset->counts_per_turn};
  if (given.model.counts_per_turn)
    given.counts_per_turn = sim::countsOf(*given.model.counts_per_turn, given.counts_per_turn);
  if (options.json)
    streams.out << identifiedObject(found.value(), given).text() << '\n';
  else
    printEstimates(found.value(), given, streams.out);
  for (const Problem& note : found.value().notes) streams.err << printed(note.sentence) << '\n';
  return writeFiles(options, found.value(), given, streams);
}

}  // namespace

void addIdentify(Command program, const Streams& streams, Exit& exit) {
  const Command command =
      program.add("identify", "Measure the simulated arm: mass, friction, damping, encoders, rendered stiffness");
  const auto options = std::make_shared<IdentifyOptions>();
  std::vector<std::string> arms;
  for (const arm::Preset& preset : arm::presets()) arms.push_back(preset.name);
  command.option("--arm", options->arm, "Geometry of the arm").showDefault().oneOf(arms);
  addArmModelOption(command, options->arm_model);
  command
      .option("--at_mm", options->at_mm,
              "Position at which the tip oscillates, mm: three numbers; six or nine for two or three positions")
      .withCommas()
      .expected(3, 9)
      .range(-1e6, 1e6);
  command.option("--rate", options->rate_hz, "Ticks per second").showDefault().range(100, 10000);
  command.option("--seed", options->seed, "Seed of the first rest position of the tip").showDefault().nonNegative();
  command.option("--name", options->name, "Name of the model that is written").showDefault();
  command.option("--out", options->out, "Write the model to this file, for --arm-model and for the window");
  command.option("--report", options->report, "Write a report (Markdown) to this file");
  command.flag("--json", options->json, "One JSON object instead of the table");
  command.footer(
      "Given: the value set in the simulation, or the commanded stiffness. Uncertainty: one standard deviation. Below: "
      "not distinguishable from zero.");
  command.whenChosen([options, &streams, &exit] {
    if (options->at_mm.size() % 3 != 0) options::refuse("--at_mm: takes 3, 6 or 9 numbers");
    exit = runIdentification(*options, streams);
  });
}

}  // namespace underact::cli
