#include "core/chain/table_check.h"

#include <cmath>
#include <string>

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

/// At a posture in which nothing lines up by chance.
bool movesTip(std::span<const DhRow> rows) {
  const Chain chain = chainFromDh(rows, Pose::Identity(), Pose::Identity());
  JointValues q{};
  for (std::size_t joint = 0; joint < rows.size(); ++joint) q[joint] = 0.3 + 0.7 * static_cast<double>(joint);
  return jacobian(chain, q).topRows<3>().norm() > kNothing_m;
}

}  // namespace

Problems impossibleIn(std::span<const DhRow> rows) {
  Problems problems;
  if (rows.empty()) problems.push_back({"A table has a row at least: a chain without a joint moves nothing.", {}});
  if (rows.size() > kMaxJoints)
    problems.push_back({"A table has " + std::to_string(kMaxJoints) + " rows at most.", {}});
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const DhRow& row = rows[index];
    const auto say = [&](const char* key, const std::string& sentence) {
      problems.push_back({sentence, {{}, static_cast<int>(index) + 1, 0, key}});
    };
    const std::string here = " of row " + numberOf(index);
    const auto judgeTurn = [&](const char* key, const char* name, double turn_rad) {
      if (!(std::abs(turn_rad) <= kMostTurn_rad)) say(key, name + here + " is an angle from -360 to 360 degrees.");
    };
    const auto judgeLength = [&](const char* key, const char* name, double length_m) {
      if (!(std::abs(length_m) <= kLongestLink_m))
        say(key, name + here + " is a length from -1000 to 1000 mm: a longer one is beyond the picture.");
    };
    judgeTurn("alpha_deg", "The twist alpha", row.alpha_rad);
    judgeLength("a_mm", "The length a", row.a_m);
    judgeTurn("theta_deg", "The angle theta", row.theta_rad);
    judgeLength("d_mm", "The offset d", row.d_m);
    if (!(row.min <= row.max)) say("min", "The limits" + here + " leave no room: the least is above the most.");
  }
  return problems;
}

Problems oddIn(std::span<const DhRow> rows) {
  Problems problems;
  const auto say = [&](std::size_t index, const char* key, const std::string& sentence) {
    problems.push_back({sentence, {{}, static_cast<int>(index) + 1, 0, key}});
  };
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const DhRow& row = rows[index];
    if (row.a_m < 0.0)
      say(index, "a_mm",
          "a of row " + numberOf(index) +
              " is below 0. It is a distance, measured along x: with x the other way round (180 degrees more in the "
              "theta before it and in its own, alpha with the other sign) the same arm has it above 0.");
    if (index == 0 || !isParallel(row.alpha_rad)) continue;
    const std::string both = "Joints " + numberOf(index - 1) + " and " + numberOf(index);
    if (row.type == JointType::Prismatic && rows[index - 1].type == JointType::Prismatic) {
      say(index, "alpha_deg", both + " slide along the same direction: one of them adds nothing.");
    } else if (row.type == JointType::Revolute && rows[index - 1].type == JointType::Revolute &&
               std::abs(row.a_m) < kNothing_m) {
      say(index, "alpha_deg",
          both +
              " turn about the same axis: one of them adds nothing. A twist or a length is "
              "missing between them.");
    }
  }
  if (!movesTip(rows))
    problems.push_back(
        {"No joint moves the tip: it stands on every axis. A length a, or an offset d beyond a twist, is "
         "missing.",
         {}});
  return problems;
}

}  // namespace underact::chain
