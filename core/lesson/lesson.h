#pragma once
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/lesson/quantity.h"

namespace underact::lesson {

// A lesson as a teacher writes it. What a student's hand has to show is a measured quantity and a condition on it.

/// What is measured: a quantity, or one value of it.
struct Measure {
  const Quantity* quantity = nullptr;  // of quantities()
  std::size_t part = 0;                // 1 to quantity->parts; 0: as a whole
};

/// A condition on a measure: between two numbers, or near a point.
struct Criterion {
  Measure measure;
  double above = -kInfinity;
  double below = kInfinity;
  std::vector<double> near;  // one for each value of the measure, NaN: whichever; empty: above and below count
  double within = 0.0;       // of near
};

/// The condition holds for a time without a break.
struct Hold {
  Criterion wanted;
  double for_s = 0.0;
};

/// Each of several points is visited, in any order.
struct Visit {
  Measure measure;
  std::vector<std::vector<double>> places;
  double within = 0.0;
};

/// The measure covers a range of this size.
struct Span {
  Measure measure;
  double by = 0.0;
};

/// The measure oscillates about a value this often within a time, further than `by` to either side.
struct Cross {
  Measure measure;
  double value = 0.0;
  double by = 0.0;
  int times = 1;
  double in_s = 1.0;
};

/// A question whose answer is a number: a fixed one, or a measure at the moment of the answer.
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

/// What a wrong answer to a question shows.
struct Misconception {
  double answer = 0.0;  // a number, or the number of a choice
  std::string name;
};

/// A task, which counts as solved for good once it was, and conditions that have to hold until then.
struct Check {
  Task task;
  std::vector<Criterion> meanwhile;
  std::string say;                            // the teacher's own words while it is not solved; empty: none
  std::vector<Misconception> misconceptions;  // of its question
  SourceLocation place;
};

/// A page of a lesson: what it says, what it shows and what it checks.
struct Step {
  std::string title;
  std::string text;        // Markdown with $formulas$
  std::string hint;        // the same; empty: none
  std::string scene;       // a shipped scene's name, or a file seen from the lesson's; empty: that of the step before
  bool continues = false;  // scene and arm stay as the student left them in the step before
  std::vector<double> pose_deg;     // where the simulated arm begins, ° or mm by joint; empty: at rest
  std::string camera;               // empty: the home view
  std::vector<std::string> layers;  // that are shown besides
  std::vector<std::string> panels;  // that are brought forward
  std::vector<Check> checks;        // none: it is read only
  SourceLocation place;
};

/// A lesson file as it was read; see the guide, "Writing lessons".
struct Lesson {
  std::string title;
  std::string group;
  double order = 0.0;    // among all lessons
  double minutes = 0.0;  // that it takes; 0: not said
  std::string about;
  std::vector<Step> steps;  // at least one
  std::string file;
};

/// The path of the step's scene: its own, or that of the last step before it that has one. scene_folder: of the scenes
/// that ship with the program.
std::string sceneFileOf(const Lesson& lesson, std::size_t step, const std::string& scene_folder);

/// Whether a step names a scene that ships with the program, whose folder has to be found then.
bool namesShippedScene(const Lesson& lesson);

/// A question of either kind; null: the check asks nothing.
const std::string* questionOf(const Check& check);

}  // namespace underact::lesson
