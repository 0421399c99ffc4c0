#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/progress.h"
#include "app/cli/python.h"
#include "app/cli/recording.h"
#include "app/cli/scene_file.h"
#include "app/cli/session_table.h"
#include "core/base/printed.h"
#include "core/record/columns_text.h"
#include "core/record/csv.h"
#include "core/record/csv_metadata.h"
#include "core/record/participant_files.h"
#include "core/record/recorder.h"
#include "core/record/session.h"
#include "core/system/signals.h"

namespace underact::cli {
namespace {

/// A file that does not exist or cannot be opened is a file error; one that is not a session is bad input.
Exit showSession(const std::string& path, bool json, const Streams& streams) {
  Result<record::Session> session = record::Session::open(path);
  if (!session) return fail(session.problems(), streams);
  json ? printAsJson(session.value(), streams.out) : printAsTable(session.value(), streams.out);
  print(session.value().info().damage, streams.err);
  return session.value().info().damage.empty() ? Exit::Success : Exit::BadInput;
}

/// Exit status 1 where anything that was run differs, as with diff.
Exit compareSessions(const std::vector<std::string>& paths, bool json, const Streams& streams) {
  Result<record::Session> a = record::Session::open(paths[0]);
  if (!a) return fail(a.problems(), streams);
  Result<record::Session> b = record::Session::open(paths[1]);
  if (!b) return fail(b.problems(), streams);
  const Result<std::vector<record::SessionDifference>> found = record::differencesBetween(a.value(), b.value());
  if (!found) return fail(found.problems(), streams);
  json ? printDifferencesAsJson(found.value(), streams.out) : printDifferences(found.value(), streams.out);
  return found.value().empty() ? Exit::Success : Exit::BadInput;
}

struct ExportOptions {
  std::string file, format, out;
};

Exit exportCsv(const ExportOptions& options, const Streams& streams) {
  Result<record::Session> session = record::Session::open(options.file);
  if (!session) return fail(session.problems(), streams);
  if (!options.out.empty()) {
    const Problems problems = record::checkCsvNames(options.file, options.out);
    if (!problems.empty()) return fail(problems, Exit::File, streams);
  }
  Result<record::CsvWriter> csv = options.out.empty()
                                      ? record::CsvWriter::toOutput()
                                      : record::CsvWriter::create(options.out, system::Existing::ReplaceFile);
  if (!csv) return fail(csv.problems(), Exit::File, streams);
  const system::Interrupt interrupt;
  Progress progress(streams);
  const record::CsvExport done = record::exportCsv(session.value(), csv.value(), [&](double share) {
    progress.show(share);
    return !interrupt.came();
  });
  print(done.unread, streams.err);
  print(done.unwritten, streams.err);
  if (done.missing > 0) streams.err << done.missing << " ticks are damaged in the file and were left out.\n";
  if (done.is_stopped) streams.err << "Stopped: what was written is not the whole session.\n";
  if (!done.unwritten.empty()) return Exit::File;
  if (!options.out.empty()) {
    const Problems problems = record::writeCsvMetadata(session.value(), options.out);
    if (!problems.empty()) return fail(problems, Exit::File, streams);
  }
  return done.isWhole() ? Exit::Success : Exit::BadInput;
}

Exit exportSession(const ExportOptions& options, const Streams& streams) {
  const std::string by_name = formatOf(options.out);
  const std::string format = !options.format.empty() ? options.format : by_name.empty() ? "csv" : by_name;
  if (!by_name.empty() && (by_name != format || by_name == "rerun" || by_name == "page")) {
    streams.err << "--out: the name ends as that of another format, so nothing was written. Give a name that ends in ."
                << (by_name == format ? "csv" : format) << ".\n";
    return Exit::Usage;
  }
  if (format == "csv") return exportCsv(options, streams);
  if (options.out.empty()) {
    streams.err << "--out: a " << format << " file needs a name.\n";
    return Exit::Usage;
  }
  return runPython({"export", options.file, "--format", format, "--out", options.out}, streams);
}

/// Finds the ticks that no row has.
class MissingTicks {
 public:
  explicit MissingTicks(const record::Session& session) {
    if (!session.changes().empty()) next_ = session.changes().front().tick;
  }
  /// Of a damaged block it is not known.
  void skip() { next_.reset(); }
  void add(std::int64_t tick, Problems& problems, const std::string& path) {
    if (next_ && tick > *next_) note(*next_, tick - 1, problems, path);
    if (tick == INT64_MAX) return skip();
    next_ = tick + 1;
  }
  std::uint64_t count() const { return count_; }

 private:
  void note(std::int64_t first, std::int64_t last, Problems& problems, const std::string& path) {
    constexpr std::size_t kMax = 100;
    // A file may hold any two numbers, so the difference is computed without overflow.
    count_ += static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first) + 1;
    if (problems.size() < kMax)
      problems.push_back(
          {"Ticks " + std::to_string(first) + " to " + std::to_string(last) + " are missing: they were not recorded.",
           {path}});
  }
  std::optional<std::int64_t> next_;
  std::uint64_t count_ = 0;
};

Exit verifyBlocks(const std::string& path, const Streams& streams) {
  Result<record::Session> session = record::Session::open(path);
  if (!session) return fail(session.problems(), streams);
  Progress progress(streams);
  Problems problems = session.value().info().damage;
  MissingTicks missing(session.value());
  const Problems unread = session.value().eachBlock(
      [&](const record::Block& block, std::int64_t row) {
        bool is_damaged = false;
        for (const servo::TickRecord& record : record::unpackTicks(block)) {
          missing.add(record.tick, problems, path);
          for (const double angle_rad : std::span(record.q_rad).subspan<record::kJointsOfTicks>())
            is_damaged = is_damaged || std::isnan(angle_rad);
        }
        if (is_damaged)
          problems.push_back({"Joints 7 and 8 of rows " + std::to_string(row + 1) + " to " +
                                  std::to_string(row + block.rows) + " are damaged.",
                              {path}});
        return true;
      },
      [&](const record::Gap& gap) {
        missing.skip();
        problems.push_back({"Rows " + std::to_string(gap.first_row + 1) + " to " +
                                std::to_string(gap.first_row + gap.rows) + " of the ticks are damaged.",
                            {path}});
      },
      [&](double share) { progress.show(share); });
  problems.insert(problems.end(), unread.begin(), unread.end());
  for (const record::ChangeRow& change : session.value().changes()) {
    const Result<std::string> text = session.value().sceneText(change);
    if (!text) problems.insert(problems.end(), text.problems().begin(), text.problems().end());
  }
  const auto dropped = static_cast<std::uint64_t>(std::max<std::int64_t>(session.value().info().dropped, 0));
  if (const std::uint64_t all = std::max(dropped, missing.count()); all > 0)
    problems.push_back(
        {std::to_string(all) + " ticks or events are missing: the recorder had no room for them.", {path}});
  print(problems, streams.err);
  if (!problems.empty()) return Exit::BadInput;
  streams.out << session.value().info().ticks << " ticks, all of them intact"
              << (session.value().info().isComplete() ? "." : "; the session was not closed.") << '\n';
  return Exit::Success;
}

Exit recover(const std::string& path, const Streams& streams) {
  const Result<std::int64_t> ticks = record::recover(path);
  if (!ticks) return fail(ticks.problems(), Exit::File, streams);
  streams.out << ticks.value() << " ticks; every program can open the file.\n";
  return Exit::Success;
}

struct InfoOptions {
  std::string file;
  std::vector<std::string> compared;
  bool json = false;
};

Exit showOrCompare(const InfoOptions& options, const Streams& streams) {
  if (options.file.empty() == options.compared.empty()) {
    streams.err << "Give one session file, or two behind --diff.\n";
    return Exit::Usage;
  }
  return options.file.empty() ? compareSessions(options.compared, options.json, streams)
                              : showSession(options.file, options.json, streams);
}

void addInfo(Command log, const Streams& streams, Exit& exit) {
  const Command command = log.add("info", "Show what a session contains, or in what two differ");
  const auto options = std::make_shared<InfoOptions>();
  command.option("file", options->file, "Session file");
  command.option("--diff", options->compared, "Name everything in which what was run differs between two sessions")
      .expected(2, 2)
      .word("A B");
  command.flag("--json", options->json, "One JSON object instead of a table");
  command.whenChosen([options, &streams, &exit] { exit = showOrCompare(*options, streams); });
}

struct RemoveOptions {
  std::string participant;
  std::vector<std::string> places;
  bool yes = false;
};

Exit removeParticipant(const RemoveOptions& options, const Streams& streams) {
  if (options.participant.empty()) {
    streams.err << "--participant: give the code of the participant, as in the field subject.\n";
    return Exit::Usage;
  }
  const record::ParticipantFiles files = record::filesOfParticipant(options.participant, options.places);
  print(files.unread, streams.err);
  for (const std::vector<std::string>* const list : {&files.sessions, &files.exports}) {
    for (const std::string& path : *list) streams.out << printed(path) << '\n';
  }
  const std::size_t count = files.sessions.size() + files.exports.size();
  if (!options.yes) {
    streams.err << count << " files would be deleted permanently. Nothing was deleted: --yes deletes them.\n";
    return files.unread.empty() ? Exit::Success : Exit::BadInput;
  }
  const Problems problems = record::removeFiles(files);
  print(problems, streams.err);
  streams.err << count - problems.size()
              << " files were deleted permanently. Copies elsewhere, and backups, were not.\n";
  if (!problems.empty()) return Exit::File;
  return files.unread.empty() ? Exit::Success : Exit::BadInput;
}

void addRemove(Command log, const Streams& streams, Exit& exit) {
  const Command command =
      log.add("remove", "Delete permanently all sessions of a participant, and what was exported from them");
  const auto options = std::make_shared<RemoveOptions>();
  command.option("--participant", options->participant, "The code, as in the field subject").required().word("CODE");
  command.option("places", options->places, "Sessions, and folders to look in, with those below")
      .required()
      .expected(1, -1);
  command.flag("--yes", options->yes, "Delete; without it the files are listed only");
  command.whenChosen([options, &streams, &exit] { exit = removeParticipant(*options, streams); });
}

void addColumns(Command log, const Streams& streams, Exit& exit) {
  const Command command =
      log.add("columns", "Print the table of a session's columns, with units, frames and meanings, as JSON");
  command.whenChosen([&streams, &exit] {
    streams.out << record::columnsJson() << '\n';
    exit = Exit::Success;
  });
}

void addExport(Command log, const Streams& streams, Exit& exit) {
  const Command command = log.add("export", "Export a session as CSV, Parquet or MCAP");
  const auto options = std::make_shared<ExportOptions>();
  command.option("file", options->file, "Session file").required();
  command
      .option("--format", options->format,
              "Format of the file; by default that of the name of --out, else CSV. Parquet and MCAP require the Python "
              "libraries pyarrow and mcap")
      .oneOf({"csv", "parquet", "mcap"});
  command.option("--out", options->out, "File to write; by default CSV goes to standard output");
  command.whenChosen([options, &streams, &exit] { exit = exportSession(*options, streams); });
}

struct PlotOptions {
  std::string file, kind = "all", out;
  std::vector<std::string> more;
};

void addPlot(Command log, const Streams& streams, Exit& exit) {
  const Command command = log.add("plot", "Plot a session as PNG, SVG or PDF, with matplotlib");
  const auto options = std::make_shared<PlotOptions>();
  command.option("file", options->file, "Session file").required();
  command.option("--kind", options->kind, "What to draw")
      .showDefault()
      .oneOf({"error", "force", "displacement-force", "path", "angles", "joints", "energy", "spectrum", "lateness",
              "all"});
  command.option("--out", options->out, "File to write: .png, .svg or .pdf").required();
  for (const char* name : {"--width", "--from", "--to"}) {
    command.option(
        name,
        [options, name](const std::string& value) {
          options->more.insert(options->more.end(), {name, value});
        },
        std::string(name) == "--width"  ? "Width of the figure, inches: 3.5 or 7"
        : std::string(name) == "--from" ? "Start of the time that is drawn, s"
                                        : "End of the time that is drawn, s");
  }
  command.whenChosen([options, &streams, &exit] {
    std::vector<std::string> arguments{"plot", options->file, "--kind", options->kind, "--out", options->out};
    arguments.insert(arguments.end(), options->more.begin(), options->more.end());
    exit = runPython(arguments, streams);
  });
}

}  // namespace

void addLog(Command program, const Streams& streams, Exit& exit) {
  const Command log = program.add("log", "Recorded sessions: inspect, compare, export, plot, verify, recover, remove");
  log.mustChoose();
  addInfo(log, streams, exit);
  addColumns(log, streams, exit);
  addExport(log, streams, exit);
  addPlot(log, streams, exit);
  const Command verifying = log.add("verify", "Check every block of a session against its checksum");
  const auto verified = std::make_shared<std::string>();
  verifying.option("file", *verified, "Session file").required();
  verifying.whenChosen([verified, &streams, &exit] { exit = verifyBlocks(*verified, streams); });
  const Command recovering = log.add(
      "recover", "Close, in place, a session that a killed program left open, so that all programs can open it");
  const auto recovered = std::make_shared<std::string>();
  recovering.option("file", *recovered, "Session file").required();
  recovering.whenChosen([recovered, &streams, &exit] { exit = recover(*recovered, streams); });
  addRemove(log, streams, exit);
}

}  // namespace underact::cli
