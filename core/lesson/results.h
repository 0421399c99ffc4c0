#pragma once
#include <string>
#include <vector>

#include "core/lesson/report.h"

namespace underact::lesson {

/// A line of a class's table: what a student did in a lesson.
struct ResultRow {
  std::string student, lesson, title, date;  // as in Report
  std::size_t steps = 0, solved = 0;
  std::size_t stopped_at = 0;  // the first step not solved, from 1; 0: all are
  std::string stopped_title;   // of that step
  std::size_t attempts = 0, wrong = 0;
  double minutes = 0.0;
  std::string misconception;  // most frequent in the step where the student stopped, else in the lesson; empty: none
  std::string report;         // its file, seen from the folder
};

/// The reports of a folder, by student and lesson.
struct ClassResults {
  std::vector<ResultRow> rows;
  Problems unread;  // one for each file that is no valid report
  Problems older;   // one for each report whose student has a later one of the lesson
};

inline constexpr std::size_t kMaxReports = 1000;

/// Reads the web pages in a folder and, as Moodle hands out submissions, in its folders. Reports without a name are
/// each of another student. Problems: the folder cannot be read.
Result<ClassResults> readResults(const std::string& folder);

/// The rows, a header first. What a spreadsheet would take for a formula begins with an apostrophe.
std::string resultsCsv(const ClassResults& results);

/// For Moodle's import of grades: a row for each student with a name, a column for each lesson, in percent of its
/// steps.
std::string moodleCsv(const ClassResults& results);

/// Reports without a name, which moodleCsv() leaves out.
std::size_t withoutName(const ClassResults& results);

}  // namespace underact::lesson
