#include "core/registration/registration_file.h"

#include <cmath>

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/json/object_reader.h"
#include "core/json/text.h"

namespace underact::registration {
namespace {

using json::Findings;
using json::numberText;
using json::ObjectReader;
using json::Value;

constexpr double kMaxSpread_mm = 1e3;
constexpr double kSamePlace_mm = 0.01, kSameTurn = 1e-4;  // of an X_DW that was rounded by a person
constexpr std::size_t kLargest = std::size_t{1} << 20;    // bytes; eight marks are a thousand

void readWords(ObjectReader& object, const char* key, bool required, std::string& text) {
  if (const Value* const value = object.find(key, required))
    json::readText(*value, object.pathOf(key), text, object.findings());
}

/// Reads a position in mm that keeps its bits when converted to m and back: not every number does, so the text is
/// written accordingly.
void readPlace(ObjectReader& object, const char* key, Vec3& p) {
  Vec3 p_mm = Vec3::Zero();
  const Value* const value = object.find(key, true);
  if (value == nullptr) return;
  json::readNumber(*value, object.pathOf(key), p_mm, object.findings());
  p = kMetrePerMillimetre * p_mm;
}

Touch readTouch(const Value& value, const std::string& path, Findings& findings) {
  Touch touch;
  if (!isKind(value, json::JsonKind::Object, path,
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"),
                     {"{\"p_DM_mm\": [0, 0, 0], \"p_WM_mm\": [1, 2, 3]}"}),
              findings))
    return touch;
  ObjectReader object(value, path, phrase(TRANSLATE_NOOP("problem", "a reference point")), findings);
  readPlace(object, "p_DM_mm", touch.p_DM);
  readPlace(object, "p_WM_mm", touch.p_WM);
  if (const Value* const spread = object.find("spread_mm")) {
    double spread_mm = 0.0;
    json::readNumber(*spread, object.pathOf("spread_mm"), spread_mm, findings);
    if (!(spread_mm >= 0.0 && spread_mm <= kMaxSpread_mm))
      findings.add(*spread, object.pathOf("spread_mm"),
                   phrase(TRANSLATE_NOOP("problem", "This must be from 0 to 1000 mm.")));
    touch.spread_m = kMetrePerMillimetre * spread_mm;
  }
  object.finish();
  return touch;
}

std::vector<Touch> readTouches(const Value& list, Findings& findings) {
  std::vector<Touch> touches;
  if (!isKind(list, json::JsonKind::Array, "marks",
              phrase(TRANSLATE_NOOP("problem", "a list of 3 to 8 reference points")), findings))
    return touches;
  if (list.items.size() < kFewestMarks || list.items.size() > kMaxMarks) {
    findings.add(list, "marks",
                 phrase(TRANSLATE_NOOP("problem", "This must be a list of 3 to 8 reference points; this one has %1."),
                        {std::to_string(list.items.size())}));
    return touches;
  }
  for (std::size_t at = 0; at < list.items.size(); ++at)
    touches.push_back(readTouch(list.items[at], "marks[" + std::to_string(at) + "]", findings));
  return touches;
}

/// The problems of an X_DW that differs from the fit.
void compare(const Value& value, const Pose& X_DW, Findings& findings) {
  const char* const kKey = "X_DW";
  const Sentence expected =
      phrase(TRANSLATE_NOOP("problem", "This must be four rows of four numbers, the last one 0, 0, 0, 1."));
  if (!isKind(value, json::JsonKind::Array, kKey, phrase(TRANSLATE_NOOP("problem", "a list of four rows")), findings))
    return;
  if (value.items.size() != 4) return findings.add(value, kKey, expected);
  Eigen::Matrix4d X = X_DW.matrix();
  X.topRightCorner<3, 1>() *= kMillimetrePerMetre;
  for (Eigen::Index row = 0; row < 4; ++row) {
    const Value& of_row = value.items[static_cast<std::size_t>(row)];
    if (of_row.kind != json::JsonKind::Array || of_row.items.size() != 4) return findings.add(of_row, kKey, expected);
    for (Eigen::Index column = 0; column < 4; ++column) {
      const Value& one = of_row.items[static_cast<std::size_t>(column)];
      if (one.kind != json::JsonKind::Number) return findings.add(one, kKey, expected);
      const double allowed = column == 3 ? kSamePlace_mm : kSameTurn;
      if (std::abs(one.number - X(row, column)) <= allowed) continue;
      return findings.add(
          one, kKey,
          phrase(TRANSLATE_NOOP(
                     "problem",
                     "This is not what the reference points give, %1. Leave X_DW out: it is computed from them."),
                 {numberText(X(row, column))}));
    }
  }
}

Registration readWhole(const Value& root, Findings& findings) {
  Registration registration;
  ObjectReader object(root, "", phrase(TRANSLATE_NOOP("problem", "a registration")), findings);
  const Value* const version = object.find("underact_registration", true);
  if (version != nullptr && (version->kind != json::JsonKind::Number || version->number != 1.0))
    findings.add(*version, "underact_registration",
                 phrase(TRANSLATE_NOOP("problem", "This program reads version 1 of registrations.")));
  readWords(object, "arm", true, registration.arm);
  readWords(object, "date", true, registration.date);
  readWords(object, "program", false, registration.program);
  const Value* const marks = object.find("marks", true);
  const Value* const pose = object.find("X_DW");
  if (marks != nullptr) registration.touches = readTouches(*marks, findings);
  object.finish();
  if (registration.touches.empty()) return registration;
  const Result<Fit> fit = fitTouches(registration.touches);
  if (fit) {
    registration.fit = fit.value();
    if (pose != nullptr) compare(*pose, fit.value().X_DW, findings);
  } else {
    for (const Problem& problem : fit.problems()) findings.add(*marks, "marks", problem.sentence);
  }
  return registration;
}

/// A length as text in mm that reads back to the same bits: mostly one of the doubles near 1000 l does.
std::string lengthText(double length_m) {
  const double length_mm = kMillimetrePerMetre * length_m;
  for (const double one_mm : {length_mm, std::nextafter(length_mm, kInfinity), std::nextafter(length_mm, -kInfinity)}) {
    if (kMetrePerMillimetre * one_mm == length_m) return numberText(one_mm);
  }
  return numberText(length_mm);
}

std::string placeText(const Vec3& p) {
  return "[" + lengthText(p.x()) + ", " + lengthText(p.y()) + ", " + lengthText(p.z()) + "]";
}

std::string touchText(const Touch& touch) {
  return R"({"p_DM_mm": )" + placeText(touch.p_DM) + R"(, "p_WM_mm": )" + placeText(touch.p_WM) + R"(, "spread_mm": )" +
         lengthText(touch.spread_m) + "}";
}

std::string poseText(const Pose& X_DW) {
  Eigen::Matrix4d X = X_DW.matrix();
  X.topRightCorner<3, 1>() *= kMillimetrePerMetre;
  std::string text;
  for (Eigen::Index row = 0; row < 4; ++row) {
    text += row > 0 ? ",\n           [" : "[";
    for (Eigen::Index column = 0; column < 4; ++column) text += (column > 0 ? ", " : "") + numberText(X(row, column));
    text += "]";
  }
  return "[" + text + "]";
}

}  // namespace

Result<Registration> readRegistration(std::string_view text, const std::string& file_name) {
  const Result<Value> root = json::parse(text, file_name);
  if (!root) return root.problems();
  Findings findings(file_name);
  if (!isKind(root.value(), json::JsonKind::Object, "",
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"underact_registration\": 1, ...}"}),
              findings))
    return findings.take();
  Registration registration = readWhole(root.value(), findings);
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return registration;
}

Result<Registration> readRegistrationFile(const std::string& path) {
  const Result<std::string> text =
      json::readTextFile(path, phrase(TRANSLATE_NOOP("problem", "a registration")), kLargest);
  if (!text) return text.problems();
  return readRegistration(text.value(), path);
}

std::string registrationText(const Registration& registration) {
  std::string text = "{\n  \"underact_registration\": 1";
  const auto add = [&text](const char* key, const std::string& value) {
    text += ",\n  " + json::quotedText(key) + ": " + value;
  };
  add("arm", json::quotedText(registration.arm));
  add("date", json::quotedText(registration.date));
  if (!registration.program.empty()) add("program", json::quotedText(registration.program));
  std::string marks;
  for (const Touch& touch : registration.touches) marks += (marks.empty() ? "\n    " : ",\n    ") + touchText(touch);
  add("marks", "[" + marks + "\n  ]");
  add("X_DW", poseText(registration.fit.X_DW));
  return text + "\n}\n";
}

}  // namespace underact::registration
