#include "core/chain/table_check.h"

#include <cmath>
#include <string>

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/chain/kinematics.h"

namespace underact::chain {
namespace {

constexpr double kMostTurn_rad = 2.0 * kPi;
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

Problems impossibleIn(std::span<const DhRow> rows) {
  Problems problems;
  if (rows.empty())
    problems.push_back(
        {said(TRANSLATE_NOOP("problem", "A table has a row at least: a chain without a joint moves nothing.")), {}});
  if (rows.size() > kMaxJoints)
    problems.push_back(
        {said(TRANSLATE_NOOP("problem", "A table has %1 rows at most."), {std::to_string(kMaxJoints)}), {}});
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const DhRow& row = rows[index];
    const auto say = [&](const char* key, const Sentence& sentence) {
      problems.push_back({sentence, {{}, static_cast<int>(index) + 1, 0, key}});
    };
    const std::string number = numberOf(index);
    const auto judgeTurn = [&](const char* key, const char* name, double turn_rad) {
      if (!(std::abs(turn_rad) <= kMostTurn_rad))
        say(key, said(TRANSLATE_NOOP("problem", "%1 of row %2 is an angle from -360 to 360 degrees."),
                      {said(name), number}));
    };
    const auto judgeLength = [&](const char* key, const char* name, double length_m) {
      if (!(std::abs(length_m) <= kLongestLink_m))
        say(key,
            said(TRANSLATE_NOOP("problem",
                                "%1 of row %2 is a length from -1000 to 1000 mm: a longer one is beyond the picture."),
                 {said(name), number}));
    };
    judgeTurn("alpha_deg", TRANSLATE_NOOP("problem", "The twist alpha"), row.alpha_rad);
    judgeLength("a_mm", TRANSLATE_NOOP("problem", "The length a"), row.a_m);
    judgeTurn("theta_deg", TRANSLATE_NOOP("problem", "The angle theta"), row.theta_rad);
    judgeLength("d_mm", TRANSLATE_NOOP("problem", "The offset d"), row.d_m);
    if (!(row.min <= row.max))
      say("min", said(TRANSLATE_NOOP("problem", "The limits of row %1 leave no room: the least is above the most."),
                      {number}));
  }
  return problems;
}

Problems oddIn(std::span<const DhRow> rows) {
  Problems problems;
  const auto say = [&](std::size_t index, const char* key, const Sentence& sentence) {
    problems.push_back({sentence, {{}, static_cast<int>(index) + 1, 0, key}});
  };
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const DhRow& row = rows[index];
    if (row.a_m < 0.0)
      say(index, "a_mm",
          said(TRANSLATE_NOOP("problem",
                              "a of row %1 is below 0. It is a distance, measured along x: with x the other way "
                              "round (180 degrees more in the theta before it and in its own, alpha with the other "
                              "sign) the same arm has it above 0."),
               {numberOf(index)}));
    if (index == 0 || !isParallel(row.alpha_rad)) continue;
    const std::string before = numberOf(index - 1), number = numberOf(index);
    if (row.type == JointType::Prismatic && rows[index - 1].type == JointType::Prismatic) {
      say(index, "alpha_deg",
          said(TRANSLATE_NOOP("problem", "Joints %1 and %2 slide along the same direction: one of them adds nothing."),
               {before, number}));
    } else if (row.type == JointType::Revolute && rows[index - 1].type == JointType::Revolute &&
               std::abs(row.a_m) < kNothing_m) {
      say(index, "alpha_deg",
          said(TRANSLATE_NOOP("problem",
                              "Joints %1 and %2 turn about the same axis: one of them adds nothing. A twist or a "
                              "length is missing between them."),
               {before, number}));
    }
  }
  if (!movesTip(rows))
    problems.push_back(
        {said(TRANSLATE_NOOP("problem",
                             "No joint moves the tip: it stands on every axis. A length a, or an offset d beyond a "
                             "twist, is missing.")),
         {}});
  return problems;
}

}  // namespace underact::chain
