#include <algorithm>
#include <chrono>
#include <iomanip>
#include <locale>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/progress.h"
#include "app/cli/scene_file.h"
#include "app/cli/step_report.h"
#include "core/error_bounds/catalogue.h"
#include "core/error_bounds/regression_cases.h"
#include "core/json/text.h"
#include "core/system/signals.h"

namespace underact::cli {
namespace {

using error_bounds::Row;
using error_bounds::Worst;

struct ExtremesOptions {
  std::vector<std::string> only;
  int seeds = 1, count = 20'000;
  std::uint64_t seed = 1;
  bool json = false, csv = false;
  std::string keep;
};

/// A row, its worst case, and the time that it took.
struct Measured {
  const Row* row;
  Worst worst;
  double seconds = 0.0;
  bool isBroken() const { return !(worst.error_ulp <= row->promised_ulp); }
};

/// The requested rows, in the order of the catalogue; none, and a sentence, if a key is unknown.
std::vector<const Row*> rowsOf(const ExtremesOptions& options, const Streams& streams) {
  std::vector<std::string> known;
  for (const Row& row : error_bounds::catalogue()) known.emplace_back(row.key);
  for (const std::string& key : options.only) {
    if (error_bounds::findRow(key) != nullptr) continue;
    const std::string near = json::nearestWord(key, known);
    streams.err << "--only: there is no row " << json::shown(key) << "."
                << (near.empty() ? "" : " Did you mean \"" + near + "\"?") << " Rows: " << json::listed(known, "and")
                << ".\n";
    return {};
  }
  std::vector<const Row*> rows;
  for (const Row& row : error_bounds::catalogue()) {
    const bool asked =
        options.only.empty() || std::find(options.only.begin(), options.only.end(), row.key) != options.only.end();
    if (asked) rows.push_back(&row);
  }
  return rows;
}

/// Three digits are enough to read; the file has all of them.
std::string shortly(double number) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(3) << number;
  return text.str();
}

JsonObject measuredObject(const Measured& measured) {
  JsonObject object;
  object.addText("key", measured.row->key);
  object.addText("kind", name(measured.row->kind));
  object.addText("asked", measured.row->asked);
  object.addNumber("error_ulp", measured.worst.error_ulp);
  object.addNumber("promised_ulp", measured.row->promised_ulp);
  object.addText("promise", measured.row->promise);
  object.addBool("kept", !measured.isBroken());
  object.addInteger("cases", measured.worst.cases);
  object.addInteger("degenerate", measured.worst.degenerate);
  object.addNumber("seconds", measured.seconds);
  object.addText("input", wordsOf(*measured.row, measured.worst.input));
  return object;
}

void printMeasured(const Measured& measured, const ExtremesOptions& options, std::ostream& out) {
  const Row& row = *measured.row;
  const Worst& worst = measured.worst;
  if (options.json) {
    out << measuredObject(measured).text() << '\n';
  } else if (options.csv) {
    out << row.key << ',' << name(row.kind) << ",\"" << row.asked << "\"," << error_bounds::textOf(worst.error_ulp)
        << ',' << error_bounds::textOf(row.promised_ulp) << ",\"" << row.promise << "\"," << worst.cases << ','
        << worst.degenerate << ',' << shortly(measured.seconds) << ",\"" << wordsOf(row, worst.input) << "\"\n";
  } else {
    out << std::left << std::setw(24) << row.key << std::right << std::setw(10) << shortly(worst.error_ulp)
        << std::setw(10) << shortly(row.promised_ulp) << std::setw(9) << worst.cases << std::setw(8)
        << shortly(100.0 * static_cast<double>(worst.degenerate) /
                   static_cast<double>(std::max<std::int64_t>(worst.cases, 1)))
        << " %" << std::setw(8) << shortly(measured.seconds) << "  " << row.asked
        << (measured.isBroken() ? "  BROKEN" : "") << '\n';
    if (measured.isBroken()) out << "    " << wordsOf(row, worst.input) << '\n';
  }
  out.flush();
}

void printHead(const ExtremesOptions& options, std::ostream& out) {
  if (options.json) return;
  if (options.csv) {
    out << "key,kind,asked,error_ulp,promised_ulp,promise,cases,degenerate,seconds,input\n";
  } else {
    out << "row                      worst ulp   promise    cases  degenerate    s  asked\n";
  }
}

Exit measureAll(const ExtremesOptions& options, const Streams& streams) {
  const std::vector<const Row*> rows = rowsOf(options, streams);
  if (rows.empty()) return Exit::Usage;
  const system::Interrupt interrupt;
  Progress progress(streams);
  std::vector<error_bounds::RegressionCase> kept;
  int broken = 0;
  printHead(options, streams.out);
  for (std::size_t index = 0; index < rows.size() && !interrupt.came(); ++index) {
    const auto start = std::chrono::steady_clock::now();
    Measured measured{rows[index], {}};
    for (int seed = 0; seed < options.seeds && !interrupt.came(); ++seed) {
      progress.show((static_cast<double>(index) + static_cast<double>(seed) / options.seeds) /
                    static_cast<double>(rows.size()));
      const std::uint64_t one = options.seed + static_cast<std::uint64_t>(seed);
      measured.worst =
          worse(measured.worst, measure(*rows[index], one, options.count, [&] { return interrupt.came(); }));
    }
    measured.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (measured.worst.cases == 0) break;
    printMeasured(measured, options, streams.out);
    broken += measured.isBroken() ? 1 : 0;
    kept.push_back({rows[index]->key, measured.worst.error_ulp, measured.worst.input});
  }
  progress.show(1.0);
  if (interrupt.came()) {
    streams.err << "Ended early; only measured rows are printed"
                << (options.keep.empty() ? ".\n"
                                         : ", and nothing was saved, because a part would look like the whole.\n");
    if (!options.keep.empty()) return Exit::BadInput;
  }
  if (!options.keep.empty()) {
    const Problems problems = writeText(options.keep, textOf(kept));
    print(problems, streams.err);
    if (!problems.empty()) return Exit::File;
  }
  if (broken == 0) return Exit::Well;
  streams.err << broken << (broken == 1 ? " promise is" : " promises are") << " not kept.\n";
  return Exit::BadInput;
}

}  // namespace

void addLabExtremes(Command lab, const Streams& streams, Exit& exit) {
  const auto options = std::make_shared<ExtremesOptions>();
  const Command command = lab.add(
      "extremes", "Test every shape, arm, chain, solver, law and limit where numbers break, against a hundred digits");
  command.option("--only", options->only, "Only these rows, separated by commas, as in --only shape_circle,law_pid")
      .withCommas();
  command
      .option("--count", options->count, "Cases of a cheap row for each seed; an expensive row runs a fraction of them")
      .range(1, 1'000'000'000)
      .showUsual();
  command.option("--seeds", options->seeds, "Number of seeds").range(1, 1'000'000).showUsual();
  command.option("--seed", options->seed, "The first seed").showUsual();
  command.option("--keep", options->keep, "Write the worst case of each row to this file, for the tests");
  const Option json = command.flag("--json", options->json, "One JSON object per row instead of the table");
  command.flag("--csv", options->csv, "The table as CSV").excludes(json);
  command.footer(
      "Exit status 1 if a promise is not kept. The page \"Measured: numerical extremes\" of the guide has the table.");
  command.whenChosen([options, &streams, &exit] { exit = measureAll(*options, streams); });
}

}  // namespace underact::cli
