#include "core/chain/table_check.h"

#include <cmath>
#include <string>

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/chain/kinematics.h"

namespace underact::chain {
namespace {

constexpr double kMaxTurn_rad = 2.0 * kPi;
constexpr double kNothing_m = 1e-9, kNothing_rad = 1e-9;

std::string numberOf(std::size_t index) {
  return std::to_string(index + 1);
}

bool isParallel(double alpha_rad) {
  return std::abs(std::remainder(alpha_rad, kPi)) < kNothing_rad;
}

/// Whether a joint moves the tip, at a configuration in which nothing is aligned by chance.
bool movesTip(std::span<const DhRow> rows) {
  const Chain chain = chainFromDh(rows, Pose::Identity(), Pose::Identity());
  JointValues q{};
  for (std::size_t joint = 0; joint < rows.size(); ++joint) q[joint] = 0.3 + 0.7 * static_cast<double>(joint);
  return jacobian(chain, q).topRows<3>().norm() > kNothing_m;
}

}  // namespace

Problems tableErrors(std::span<const DhRow> rows) {
  Problems problems;
  if (rows.empty())
    problems.push_back(
        {phrase(TRANSLATE_NOOP("problem", "A table needs at least one row: a chain without joints cannot move.")), {}});
  if (rows.size() > kMaxJoints)
    problems.push_back(
        {phrase(TRANSLATE_NOOP("problem", "A table has at most %1 rows."), {std::to_string(kMaxJoints)}), {}});
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const DhRow& row = rows[index];
    const auto say = [&](const char* key, const Sentence& sentence) {
      problems.push_back({sentence, {{}, static_cast<int>(index) + 1, 0, key}});
    };
    const std::string number = numberOf(index);
    const auto judgeTurn = [&](const char* key, const char* name, double turn_rad) {
      if (!(std::abs(turn_rad) <= kMaxTurn_rad))
        say(key, phrase(TRANSLATE_NOOP("problem", "%1 of row %2 must be from -360 to 360 degrees."),
                        {phrase(name), number}));
    };
    const auto judgeLength = [&](const char* key, const char* name, double length_m) {
      if (!(std::abs(length_m) <= kLongestLink_m))
        say(key, phrase(TRANSLATE_NOOP(
                            "problem",
                            "%1 of row %2 must be from -1000 to 1000 mm: a longer one does not fit into the picture."),
                        {phrase(name), number}));
    };
    judgeTurn("alpha_deg", TRANSLATE_NOOP("problem", "The twist alpha"), row.alpha_rad);
    judgeLength("a_mm", TRANSLATE_NOOP("problem", "The length a"), row.a_m);
    judgeTurn("theta_deg", TRANSLATE_NOOP("problem", "The angle theta"), row.theta_rad);
    judgeLength("d_mm", TRANSLATE_NOOP("problem", "The offset d"), row.d_m);
    if (!(row.min <= row.max))
      say("min", phrase(TRANSLATE_NOOP("problem", "In row %1 the lower limit is above the upper limit."), {number}));
  }
  return problems;
}

Problems tableWarnings(std::span<const DhRow> rows) {
  Problems problems;
  const auto say = [&](std::size_t index, const char* key, const Sentence& sentence) {
    problems.push_back({sentence, {{}, static_cast<int>(index) + 1, 0, key}});
  };
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const DhRow& row = rows[index];
    if (row.a_m < 0.0)
      say(index, "a_mm",
          phrase(
              TRANSLATE_NOOP(
                  "problem",
                  "a of row %1 is below 0, but it is a distance along x. Reverse x to describe the same arm: add 180 "
                  "degrees to theta in this row and in the row before it, and change the signs of a and alpha."),
              {numberOf(index)}));
    if (index == 0 || !isParallel(row.alpha_rad)) continue;
    const std::string before = numberOf(index - 1), number = numberOf(index);
    if (row.type == JointType::Prismatic && rows[index - 1].type == JointType::Prismatic) {
      say(index, "alpha_deg",
          phrase(TRANSLATE_NOOP("problem", "Joints %1 and %2 slide in the same direction: one of them is redundant."),
                 {before, number}));
    } else if (row.type == JointType::Revolute && rows[index - 1].type == JointType::Revolute &&
               std::abs(row.a_m) < kNothing_m) {
      say(index, "alpha_deg",
          phrase(TRANSLATE_NOOP("problem",
                                "Joints %1 and %2 turn about the same axis: one of them is redundant. Add a twist or a "
                                "length between them."),
                 {before, number}));
    }
  }
  if (!movesTip(rows))
    problems.push_back(
        {phrase(TRANSLATE_NOOP(
             "problem",
             "No joint moves the tip: it lies on every axis. Add a length a, or an offset d after a twist.")),
         {}});
  return problems;
}

}  // namespace underact::chain
