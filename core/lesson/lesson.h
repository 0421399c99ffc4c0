#pragma once
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/lesson/quantity.h"

namespace underact::lesson {

// A lesson as a teacher writes it. What a student's hand has to show is a measured quantity and what it has to do.

/// What is measured: a quantity, or one value of it.
struct Measure {
  const Quantity* quantity = nullptr;  // of quantities()
  std::size_t part = 0;                // 1 to quantity->parts; 0: as a whole
};

/// Where a measure should be: between two numbers, or near a place.
struct Wanted {
  Measure measure;
  double above = -kInfinity;
  double below = kInfinity;
  std::vector<double> near;  // one for each value of the measure, NaN: whichever; empty: above and below count
  double within = 0.0;       // of near
};

/// It is there, and stays there for so long.
struct Hold {
  Wanted wanted;
  double for_s = 0.0;
};

/// Each of some places is visited, in any order.
struct Visit {
  Measure measure;
  std::vector<std::vector<double>> places;
  double within = 0.0;
};

/// Its least and its most value are so far apart.
struct Span {
  Measure measure;
  double by = 0.0;
};

/// It swings through a value so many times within a while, further than `by` to either side.
struct Cross {
  Measure measure;
  double value = 0.0;
  double by = 0.0;
  int times = 1;
  double in_s = 1.0;
};

/// A question that a number answers: one that the lesson knows, or one that is measured at that moment.
struct AskNumber {
  std::string question;
  std::string unit;
  double answer = kNotANumber;
  Measure measure;  // quantity not null: it is the answer
  double within = 0.0;
};

/// A question with answers to choose from.
struct AskChoice {
  std::string question;
  std::vector<std::string> choices;
  std::size_t right = 1;  // from 1
};

/// What a check asks for.
using Task = std::variant<Hold, Visit, Span, Cross, AskNumber, AskChoice>;

/// A task that counts as solved once it was, and what has to hold meanwhile.
struct Check {
  Task task;
  std::vector<Wanted> meanwhile;
  std::string say;  // the teacher's own words while it is not solved; empty: none
  Place place;
};

/// A page of a lesson: what it says, what it shows and what it checks.
struct Step {
  std::string title;
  std::string text;    // Markdown with $formulas$
  std::string hint;    // the same; empty: none
  std::string scene;   // a shipped scene's name, or a file seen from the lesson's; empty: that of the step before
  std::string camera;  // empty: as it is
  std::vector<std::string> layers;  // that are shown besides
  std::vector<std::string> panels;  // that are brought forward
  std::vector<Check> checks;        // none: it is read only
  Place place;
};

/// A lesson file as it was read; see the guide, "Writing lessons".
struct Lesson {
  std::string title;
  std::string group;
  double order = 0.0;  // among all lessons
  std::string about;
  std::vector<Step> steps;  // at least one
  std::string file;
};

/// Where the scene of the step is: its own, or that of the nearest step before it that has one. scene_folder: of the
/// scenes that ship.
std::string sceneFileOf(const Lesson& lesson, std::size_t step, const std::string& scene_folder);

/// Whether one of its scenes is one that ships, so that their folder has to be found.
bool namesShippedScene(const Lesson& lesson);

/// A question of either kind; null: the check asks nothing.
const std::string* questionOf(const Check& check);

}  // namespace underact::lesson
