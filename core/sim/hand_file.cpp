#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/nearest_rotation.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/json/object_reader.h"
#include "core/json/text.h"
#include "core/sim/hand_script.h"

namespace underact::sim {
namespace {

using json::Findings;
using json::ObjectReader;
using json::Value;

constexpr double kFurthestHand_mm = 1e6;

/// False, and a problem, for a number beyond the range of double.
bool checkFinite(const Value& value, const std::string& path, double number, Findings& findings) {
  if (std::isfinite(number)) return true;
  findings.add(value, path,
               phrase(TRANSLATE_NOOP("problem", "This is not a finite number; the largest is about 1.8e308.")));
  return false;
}

void readAmount(ObjectReader& object, const char* key, bool may_be_zero, double& amount) {
  const Value* const value = object.find(key);
  if (value == nullptr) return;
  const std::string path = object.pathOf(key);
  readNumber(*value, path, amount, object.findings());
  if (!checkFinite(*value, path, amount, object.findings())) return;
  if (amount > 0.0 || (amount == 0.0 && may_be_zero)) return;
  object.findings().add(*value, path,
                        phrase(may_be_zero ? TRANSLATE_NOOP("problem", "This must not be below 0; here it is %1.")
                                           : TRANSLATE_NOOP("problem", "This must be above 0; here it is %1."),
                               {json::numberText(amount)}));
}

HandModel readModel(const Value& value, Findings& findings) {
  HandModel hand;
  if (!isKind(value, json::JsonKind::Object, "hand",
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"mass_kg\": 0.1}"}), findings))
    return hand;
  ObjectReader object(value, "hand", phrase(TRANSLATE_NOOP("problem", "a hand")), findings);
  readAmount(object, "mass_kg", false, hand.mass_kg);
  readAmount(object, "damping_N_s_per_m", true, hand.damping_N_s_per_m);
  readAmount(object, "stiffness_N_per_m", true, hand.stiffness_N_per_m);
  object.finish();
  return hand;
}

void readTime(const Value& value, const std::string& path, double before_s, double& t_s, Findings& findings) {
  readNumber(value, path, t_s, findings);
  if (std::isnan(t_s) || !checkFinite(value, path, t_s, findings)) return;
  if (t_s <= before_s)
    findings.add(value, path, phrase(TRANSLATE_NOOP("problem", "Each time must be later than those before it.")));
}

void readPlace(const Value& value, const std::string& path, Vec3& p_WT, Findings& findings) {
  Vec3 p_mm = Vec3::Zero();
  readNumber(value, path, p_mm, findings);
  if (p_mm.cwiseAbs().maxCoeff() > kFurthestHand_mm) {
    findings.add(value, path, phrase(TRANSLATE_NOOP("problem", "Each coordinate must lie within 1e6 mm (1 km).")));
  }
  p_WT = kMetrePerMillimetre * p_mm;
}

void readTurn(const Value& value, const std::string& path, Mat3& R_WT, Findings& findings) {
  readNumber(value, path, R_WT, findings);
  if (Sentence sentence = rotationProblem(R_WT); !sentence.empty()) findings.add(value, path, std::move(sentence));
  R_WT = nearestRotation(R_WT);
}

/// before_s: the latest time before it.
HandPoint readPoint(const Value& value, const std::string& path, double before_s, Findings& findings) {
  HandPoint point;
  point.t_s = kNotANumber;  // remains where the file gives none
  const Sentence expected =
      phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"t_s\": 0, \"p_mm\": [0, 0, 60]}"});
  if (!isKind(value, json::JsonKind::Object, path, expected, findings)) return point;
  ObjectReader object(value, path, phrase(TRANSLATE_NOOP("problem", "a point of a hand's path")), findings);
  if (const Value* const t = object.find("t_s", true)) {
    readTime(*t, object.pathOf("t_s"), before_s, point.t_s, findings);
  }
  if (const Value* const p = object.find("p_mm", true)) {
    readPlace(*p, object.pathOf("p_mm"), point.p_WT, findings);
  }
  if (const Value* const R = object.find("R_WT")) {
    point.turns = true;
    readTurn(*R, object.pathOf("R_WT"), point.R_WT, findings);
  }
  object.finish();
  return point;
}

/// A point without an orientation keeps that of the one before it, the first ones that of the first that has one.
void carryTurns(std::vector<HandPoint>& path) {
  const auto first = std::find_if(path.begin(), path.end(), [](const HandPoint& point) { return point.turns; });
  if (first == path.end()) return;
  Mat3 R_WT = first->R_WT;
  for (HandPoint& point : path) {
    if (point.turns) R_WT = point.R_WT;
    point.R_WT = R_WT;
    point.turns = true;
  }
}

std::vector<HandPoint> readPath(const Value& value, Findings& findings) {
  std::vector<HandPoint> path;
  if (!isKind(value, json::JsonKind::Array, "path", phrase(TRANSLATE_NOOP("problem", "a list of points")), findings))
    return path;
  if (value.items.empty())
    findings.add(value, "path", phrase(TRANSLATE_NOOP("problem", "A path needs at least one point.")));
  double latest_s = -kInfinity;
  for (std::size_t index = 0; index < value.items.size(); ++index) {
    path.push_back(readPoint(value.items[index], "path[" + std::to_string(index) + "]", latest_s, findings));
    if (path.back().t_s > latest_s) latest_s = path.back().t_s;
  }
  carryTurns(path);
  return path;
}

}  // namespace

Result<HandScript> readHand(std::string_view text, const std::string& file_name) {
  const Result<Value> root = json::parse(text, file_name);
  if (!root) return root.problems();
  Findings findings(file_name);
  HandScript script;
  if (isKind(root.value(), json::JsonKind::Object, "",
             phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"underact_hand\": 1, ...}"}), findings)) {
    ObjectReader object(root.value(), "", phrase(TRANSLATE_NOOP("problem", "a hand file")), findings);
    if (const Value* const version = object.find("underact_hand", true)) {
      double number = 1.0;
      readNumber(*version, "underact_hand", number, findings);
      if (number != 1.0)
        findings.add(*version, "underact_hand",
                     phrase(TRANSLATE_NOOP("problem", "This program reads version 1 only.")));
    }
    if (const Value* const hand = object.find("hand")) script.hand = readModel(*hand, findings);
    if (const Value* const path = object.find("path", true)) script.path = readPath(*path, findings);
    object.finish();
  }
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return script;
}

Result<HandScript> readHandFile(const std::string& path) {
  const Result<std::string> text = json::readTextFile(path, phrase(TRANSLATE_NOOP("problem", "a hand")));
  if (!text) return text.problems();
  return readHand(text.value(), path);
}

}  // namespace underact::sim
