#include "app/cli/json_lines.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <ostream>
#include <string>

#include "core/base/nearest_rotation.h"
#include "core/kinematics/units.h"

namespace underact::cli {
namespace {

using json::JsonKind;
using json::Value;

using kinematics::kFarthest_mm;
using kinematics::kLargestAngle_rad;

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

bool isNumberUpTo(const Value& value, double largest) {
  return value.kind == JsonKind::Number && std::abs(value.number) <= largest;
}

}  // namespace

Exit answerLines(const Streams& streams, const std::function<Result<JsonObject>(std::string_view line)>& answer) {
  Exit exit = Exit::Success;
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
  if (object.kind != JsonKind::Object) return Problems{{std::string("A line is an object: ") + example + ".", {}}};
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
  if (list.kind != JsonKind::Array || list.items.size() != count ||
      !std::all_of(list.items.begin(), list.items.end(), fits)) {
    if (count == 6) return problem(key, "must be six angles in rad, of magnitude 1e6 or less.");
    const std::string sentence = "must have one entry for each joint, here " + std::to_string(count) +
                                 ": angles in rad (mm where the joint slides), of magnitude 1e6 or less.";
    return problem(key, sentence.c_str());
  }
  std::vector<double> q;
  for (const Value& angle : list.items) q.push_back(angle.number);
  return kinematics::jointsOf(chain, q);
}

std::vector<double> jointNumbers(const chain::Chain& chain, const chain::JointValues& q) {
  std::vector<double> numbers(chain.joints.size());
  kinematics::writeJoints(chain, q, numbers);
  return numbers;
}

Result<Pose> readPose(const Value& line, const char* key, std::string* note) {
  const Value& rows = *line.find(key);
  const auto isRow = [](const Value& row) {
    const auto fits = [](const Value& entry) { return isNumberUpTo(entry, kFarthest_mm); };
    return row.kind == JsonKind::Array && row.items.size() == 4 &&
           std::all_of(row.items.begin(), row.items.end(), fits);
  };
  if (rows.kind != JsonKind::Array || rows.items.size() != 4 ||
      !std::all_of(rows.items.begin(), rows.items.end(), isRow)) {
    return problem(key, "must be four rows of four numbers, lengths in mm of at most 1e9.");
  }
  Eigen::Matrix4d X;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      X(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = rows.items[row].items[column].number;
    }
  }
  Pose pose = Pose::Identity();
  if (const std::string wrong = kinematics::readPose(X, pose); !wrong.empty()) return problem(key, wrong.c_str());
  if (Sentence given = rotationNote(X.topLeftCorner<3, 3>()); !given.empty())
    *note = std::string("\"") + key + "\": " + std::string(given);
  return pose;
}

}  // namespace underact::cli
