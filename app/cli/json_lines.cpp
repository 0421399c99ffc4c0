#include "app/cli/json_lines.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <ostream>
#include <string>

#include "core/base/units.h"

namespace underact::cli {
namespace {

using json::Kind;
using json::Value;

constexpr double kLargestAngle_rad = 1e6;
constexpr double kFarthest_mm = 1e9;
constexpr double kRounding = 1e-14;  // of doubles: not corrected

JsonObject refusal(const Problems& problems, std::int64_t line) {
  std::string sentences;
  for (const Problem& problem : problems) sentences += (sentences.empty() ? "" : " ") + problem.sentence;
  JsonObject object;
  object.addText("error", sentences);
  object.addInteger("line", line);
  return object;
}

Problems problem(const char* key, const char* sentence) {
  return {{std::string("\"") + key + "\" " + sentence, {}}};
}

double unitOf(const chain::Joint& joint) {
  return joint.type == chain::JointType::Revolute ? 1.0 : kMetrePerMillimetre;
}

bool isNumberUpTo(const Value& value, double largest) {
  return value.kind == Kind::Number && std::abs(value.number) <= largest;
}

}  // namespace

Exit answerLines(const Streams& streams, const std::function<Result<JsonObject>(std::string_view line)>& answer) {
  Exit exit = Exit::Well;
  std::int64_t number = 0;
  for (std::string line; streams.out && std::getline(streams.in, line);) {
    ++number;
    const Result<JsonObject> answered = answer(line);
    if (!answered) exit = Exit::BadInput;
    streams.out << (answered ? answered.value() : refusal(answered.problems(), number)).text() << '\n' << std::flush;
  }
  return exit;
}

Result<Value> readLine(std::string_view text, std::initializer_list<std::string_view> keys, const char* example,
                       std::initializer_list<std::string_view> may_lack) {
  Result<Value> parsed = json::parse(text, "");
  if (!parsed) return parsed.problems();
  const Value& object = parsed.value();
  if (object.kind != Kind::Object) return Problems{{std::string("A line is an object: ") + example + ".", {}}};
  Problems problems;
  for (const std::string& key : object.keys) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end() &&
        std::find(may_lack.begin(), may_lack.end(), key) == may_lack.end()) {
      problems.push_back({"Unknown key \"" + key + "\"; a line is " + example + ".", {}});
    } else if (std::count(object.keys.begin(), object.keys.end(), key) > 1) {
      problems.push_back({"The key \"" + key + "\" appears twice.", {}});
    }
  }
  for (const std::string_view key : keys) {
    if (object.find(key) == nullptr)
      problems.push_back({"\"" + std::string(key) + "\" is missing; a line is " + example + ".", {}});
  }
  if (!problems.empty()) return problems;
  return parsed;
}

Result<chain::JointValues> readJoints(const Value& line, const char* key, const chain::Chain& chain) {
  const Value& list = *line.find(key);
  const std::size_t count = chain.joints.size();
  const auto fits = [](const Value& angle) { return isNumberUpTo(angle, kLargestAngle_rad); };
  if (list.kind != Kind::Array || list.items.size() != count ||
      !std::all_of(list.items.begin(), list.items.end(), fits)) {
    if (count == 6) return problem(key, "must be six angles in rad, of magnitude 1e6 or less.");
    const std::string sentence = "must have one entry for each joint, here " + std::to_string(count) +
                                 ": angles in rad (mm where the joint slides), of magnitude 1e6 or less.";
    return problem(key, sentence.c_str());
  }
  chain::JointValues q{};
  for (std::size_t i = 0; i < count; ++i) q[i] = list.items[i].number * unitOf(chain.joints[i]);
  return q;
}

std::vector<double> jointNumbers(const chain::Chain& chain, std::span<const double> q) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const bool turns = chain.joints[i].type == chain::JointType::Revolute;
    numbers.push_back(turns ? q[i] : kMillimetrePerMetre * q[i]);
  }
  return numbers;
}

Result<Pose> readPose(const Value& line, const char* key) {
  const Value& rows = *line.find(key);
  const auto isRow = [](const Value& row) {
    const auto fits = [](const Value& entry) { return isNumberUpTo(entry, kFarthest_mm); };
    return row.kind == Kind::Array && row.items.size() == 4 && std::all_of(row.items.begin(), row.items.end(), fits);
  };
  if (rows.kind != Kind::Array || rows.items.size() != 4 || !std::all_of(rows.items.begin(), rows.items.end(), isRow)) {
    return problem(key, "must be four rows of four numbers, lengths in mm of at most 1e9.");
  }
  Eigen::Matrix4d X;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      X(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = rows.items[row].items[column].number;
    }
  }
  const Mat3 R = X.topLeftCorner<3, 3>();
  const double error = (R * R.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff();
  if (error > kRotationTolerance || R.determinant() < 0.0)
    return problem(key, "is not a rotation: its rows must be orthonormal, with determinant +1.");
  if (X.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) return problem(key, "must end with the row 0, 0, 0, 1.");
  Pose pose = Pose::Identity();
  pose.linear() = error > kRounding ? Eigen::Quaterniond(R).normalized().toRotationMatrix() : R;
  pose.translation() = kMetrePerMillimetre * X.topRightCorner<3, 1>();
  return pose;
}

}  // namespace underact::cli
