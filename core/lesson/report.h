#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/lesson/check.h"

namespace underact::lesson {

/// What a student did in a step.
struct StepReport {
  std::string title;
  bool solved = false;
  std::size_t attempts = 0, wrong = 0;      // answers to its questions, and how many of them were wrong
  std::vector<std::string> misconceptions;  // shown by wrong answers, one each
};

/// What a student did in a lesson. Its page carries it in a form that does not depend on the window's language.
struct Report {
  std::string student;  // as typed; empty: no name
  std::string lesson;   // name of its file, "07_stiffness"
  std::string title;
  std::string date;  // ISO 8601, local: a later one sorts behind
  double minutes = 0.0;
  std::vector<StepReport> steps;
};

/// states: of the checks of the step.
StepReport reportOf(const Step& step, bool solved, const std::vector<CheckState>& states);

/// An element for the head of an HTML page; no text in it can end it.
std::string reportData(const Report& report);

/// Reads that element from a page that others wrote. Problems: there is none, or it is invalid.
Result<Report> readReport(std::string_view page, const std::string& file_name);

}  // namespace underact::lesson
