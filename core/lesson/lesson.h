#pragma once
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/lesson/quantity.h"

namespace underact::lesson {

// A lesson as a teacher writes it. A check is a measured quantity and a condition on it.

/// What is measured: a quantity, or one value of it.
struct Measure {
  const Quantity* quantity = nullptr;  // of quantities()
  std::size_t part = 0;                // 1 to quantity->parts; 0: all of it
};

/// The required range of a measure: between two numbers, or near a value.
struct Wanted {
  Measure measure;
  double above = -kInfinity;
  double below = kInfinity;
  std::vector<double> near;  // one for each value of the measure, NaN: any; empty: above and below count
  double within = 0.0;       // of near
};

/// The measure is in the range, and stays there for a time.
struct Hold {
  Wanted wanted;
  double for_s = 0.0;
};

/// Each of several values is reached, in any order.
struct Visit {
  Measure measure;
  std::vector<std::vector<double>> places;
  double within = 0.0;
};

/// The minimum and the maximum of the measure are that far apart.
struct Span {
  Measure measure;
  double by = 0.0;
};

/// The measure crosses a value a number of times within a time, by more than `by` to either side.
struct Cross {
  Measure measure;
  double value = 0.0;
  double by = 0.0;
  int times = 1;
  double in_s = 1.0;
};

/// A question whose answer is a number: one that the lesson gives, or one that is measured at that moment.
struct AskNumber {
  std::string question;
  std::string unit;
  double answer = kNotANumber;
  Measure measure;  // quantity not null: it is the answer
  double within = 0.0;
};

/// A multiple-choice question.
struct AskChoice {
  std::string question;
  std::vector<std::string> choices;
  std::size_t right = 1;  // from 1
};

using Task = std::variant<Hold, Visit, Span, Cross, AskNumber, AskChoice>;

/// A task, which stays solved once it is, and the conditions that have to hold meanwhile.
struct Check {
  Task task;
  std::vector<Wanted> meanwhile;
  std::string say;  // the teacher's own words while it is not solved; empty: none
  Place place;
};

struct Step {
  std::string title;
  std::string text;    // Markdown with $formulas$
  std::string hint;    // likewise; empty: none
  std::string scene;   // a shipped scene's name, or a file relative to the lesson's; empty: as in the previous step
  std::string camera;  // empty: as it is
  std::vector<std::string> layers;  // that are also shown
  std::vector<std::string> panels;  // that are brought forward
  std::vector<Check> checks;        // none: the step is only read
  Place place;
};

struct Lesson {
  std::string title;
  std::string group;
  double order = 0.0;  // among all lessons
  std::string about;
  std::vector<Step> steps;  // at least one
  std::string file;
};

/// The file of the step's scene: its own, or that of the last step before it that has one. scene_folder: that of the
/// scenes that ship.
std::string sceneFileOf(const Lesson& lesson, std::size_t step, const std::string& scene_folder);

/// Whether one of its scenes ships with the program, so that their folder has to be found.
bool namesShippedScene(const Lesson& lesson);

/// A question of either kind; null: the check asks nothing.
const std::string* questionOf(const Check& check);

}  // namespace underact::lesson
