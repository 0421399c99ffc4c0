#include <filesystem>
#include <iomanip>
#include <memory>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/lesson_try.h"
#include "app/cli/scene_file.h"
#include "app/cli/shipped.h"
#include "app/cli/table.h"
#include "core/base/printed.h"
#include "core/lesson/read.h"
#include "core/lesson/results.h"
#include "core/system/resource_paths.h"

namespace underact::cli {
namespace {

Exit checkLessonFiles(const std::vector<std::string>& paths, const Streams& streams) {
  Exit exit = Exit::Success;
  const Result<std::string> scenes = system::findResource(system::Resource::Scenes);
  for (const std::string& path : paths) {
    const Result<lesson::Lesson> read = lesson::readLessonFile(path);
    if (read && !scenes && namesShippedScene(read.value())) return fail(scenes.problems(), Exit::File, streams);
    const Problems problems =
        read ? lesson::checkScenes(read.value(), scenes ? scenes.value() : std::string()) : read.problems();
    if (problems.empty()) continue;
    const Exit now = exitOf(problems);
    print(problems, now == Exit::File ? streams.err : streams.out);
    if (exit != Exit::File) exit = now;
  }
  return exit;
}

JsonObject listed(const std::string& path, const lesson::Lesson& lesson) {
  JsonObject object;
  object.addText("name", printed(std::filesystem::path(path).stem().string()));
  object.addText("title", lesson.title);
  object.addText("group", lesson.group);
  object.addInteger("steps", lesson.steps.size());
  object.addText("file", path);
  return object;
}

Exit list(bool json, const Streams& streams) {
  const Result<std::vector<std::string>> paths = shippedLessons();
  if (!paths) return fail(paths.problems(), Exit::File, streams);
  for (const std::string& path : paths.value()) {
    const Result<lesson::Lesson> read = lesson::readLessonFile(path);
    if (!read) return fail(read.problems(), streams);
    if (json) {
      streams.out << listed(path, read.value()).text() << '\n';
      continue;
    }
    streams.out << std::left << std::setw(28) << printed(std::filesystem::path(path).stem().string()) << std::setw(3)
                << read.value().steps.size() << "steps  " << printed(read.value().title) << '\n';
  }
  return Exit::Success;
}

Exit printQuantities(bool json, const Streams& streams) {
  for (const lesson::Quantity& quantity : lesson::quantities()) {
    if (json) {
      JsonObject object;
      object.addText("key", quantity.key);
      object.addText("unit", quantity.unit);
      object.addInteger("parts", quantity.parts);
      object.addText("what", quantity.what);
      streams.out << object.text() << '\n';
      continue;
    }
    const std::string parts = quantity.parts == 1 ? "" : std::to_string(quantity.parts) + " values";
    streams.out << std::left << std::setw(22) << quantity.key << std::setw(9) << quantity.unit << std::setw(10) << parts
                << quantity.what << '\n';
  }
  return Exit::Success;
}

struct ResultsOptions {
  std::string folder;
  bool json = false, csv = false, moodle = false;
};

JsonObject objectOf(const lesson::ResultRow& row) {
  JsonObject object;
  object.addText("student", row.student);
  object.addText("lesson", row.lesson);
  object.addInteger("steps", row.steps);
  object.addInteger("solved", row.solved);
  row.stopped_at > 0 ? object.addInteger("stopped_at", row.stopped_at) : object.addNull("stopped_at");
  object.addInteger("attempts", row.attempts);
  object.addNumber("minutes", row.minutes);
  row.misconception.empty() ? object.addNull("misconception") : object.addText("misconception", row.misconception);
  object.addText("report", printed(row.report));
  object.addText("title", row.title);
  object.addText("date", row.date);
  object.addInteger("wrong", row.wrong);
  row.stopped_at > 0 ? object.addText("stopped_title", row.stopped_title) : object.addNull("stopped_title");
  return object;
}

void printClass(const lesson::ClassResults& results, std::ostream& out) {
  const auto text = [](const std::string& words) { return words.empty() ? Table::Field() : Table::Field(words); };
  Table table({"student", "lesson", "date", "solved", "stopped at", "wrong answers", "misconception", "report"});
  for (const lesson::ResultRow& row : results.rows) {
    const std::string step = row.stopped_at > 0 ? std::to_string(row.stopped_at) + " " + row.stopped_title : "";
    table.add({text(row.student), row.lesson, row.date.substr(0, row.date.find('T')),
               std::to_string(row.solved) + " of " + std::to_string(row.steps), text(step),
               static_cast<std::int64_t>(row.wrong), text(row.misconception), row.report});
  }
  table.printText(out);
}

Exit printResults(const ResultsOptions& options, const Streams& streams) {
  const Result<lesson::ClassResults> read = lesson::readResults(options.folder);
  if (!read) return fail(read.problems(), Exit::File, streams);
  const lesson::ClassResults& results = read.value();
  if (options.csv) streams.out << resultsCsv(results);
  if (options.moodle) streams.out << moodleCsv(results);
  if (options.json) {
    for (const lesson::ResultRow& row : results.rows) streams.out << objectOf(row).text() << '\n';
  }
  if (!options.csv && !options.moodle && !options.json) printClass(results, streams.out);
  printNotes(results.older, streams.err);
  print(results.unread, streams.err);
  if (options.moodle && withoutName(results) > 0)
    streams.err << withoutName(results) << " reports without a name are left out.\n";
  return results.unread.empty() ? Exit::Success : Exit::BadInput;
}

void addResults(Command command, const Streams& streams, Exit& exit) {
  const Command results =
      command.add("results",
                  "Table of the reports in a folder: a row for each student and lesson, with the step where "
                  "they stopped and the misconception that their wrong answers show");
  const auto options = std::make_shared<ResultsOptions>();
  results.option("folder", options->folder, "Folder with the reports that students saved").required();
  const Option json = results.flag("--json", options->json, "One JSON object per line instead of a table");
  const Option csv = results.flag("--csv", options->csv, "CSV instead of a table").excludes(json);
  results.flag("--moodle", options->moodle, "CSV for Moodle's import of grades: a row per student, lessons in percent")
      .excludes(json)
      .excludes(csv);
  results.whenChosen([options, &streams, &exit] { exit = printResults(*options, streams); });
}

}  // namespace

void addLesson(Command program, const Streams& streams, Exit& exit) {
  const Command command =
      program.add("lesson", "Check lesson files, list the lessons, try a step, or make a table of a class");
  command.mustChoose();

  const Command checking =
      command.add("check", "Print all problems in lesson files and in the scenes they name; nothing if there are none");
  const auto paths = std::make_shared<std::vector<std::string>>();
  checking.option("files", *paths, "Lesson files").required();
  checking.whenChosen([paths, &streams, &exit] { exit = checkLessonFiles(*paths, streams); });

  const Command listing = command.add("list", "List the lessons that ship, in teaching order");
  const auto json = std::make_shared<bool>(false);
  listing.flag("--json", *json, "One JSON object per line instead of a table");
  listing.whenChosen([json, &streams, &exit] { exit = list(*json, streams); });

  const Command telling = command.add("quantities", "List what a lesson can measure: key, unit, meaning");
  const auto json_too = std::make_shared<bool>(false);
  telling.flag("--json", *json_too, "One JSON object per line instead of a table");
  telling.whenChosen([json_too, &streams, &exit] { exit = printQuantities(*json_too, streams); });

  addLessonTry(command, streams, exit);
  addResults(command, streams, exit);
}

}  // namespace underact::cli
