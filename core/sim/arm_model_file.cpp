#include "core/sim/arm_model_file.h"

#include <cmath>
#include <utility>

#include "core/base/translate.h"
#include "core/json/json.h"
#include "core/json/object_reader.h"
#include "core/json/text.h"

namespace underact::sim {
namespace {

using json::Findings;
using json::numberText;
using json::ObjectReader;
using json::quotedText;
using json::Value;

constexpr double kHeaviest_kg = 100.0, kMax = 1e6;
constexpr double kFurthest_mm = 1e6;
constexpr std::size_t kCounts = 6;  // of encoders
constexpr int kSlowest_Hz = 1, kFastest_Hz = 1'000'000;

void readAmountUpTo(ObjectReader& object, const char* key, bool required, double max, double& amount) {
  const Value* const value = object.find(key, required);
  if (value == nullptr) return;
  const std::string path = object.pathOf(key);
  json::readNumber(*value, path, amount, object.findings());
  if (value->kind != json::JsonKind::Number) return;
  if (amount >= 0.0 && amount <= max) return;
  object.findings().add(
      *value, path,
      phrase(TRANSLATE_NOOP("problem", "This must lie within 0 and %1; here it is %2."),
             {numberText(max), std::isfinite(amount) ? Sentence(numberText(amount))
                                                     : phrase(TRANSLATE_NOOP("problem", "not a finite number"))}));
  amount = 0.0;
}

void readWords(ObjectReader& object, const char* key, bool required, std::string& text) {
  if (const Value* const value = object.find(key, required))
    json::readText(*value, object.pathOf(key), text, object.findings());
}

void readCounts(const Value& list, ArmModel& model, Findings& findings) {
  const char* const kKey = "counts_per_turn";
  if (!isKind(list, json::JsonKind::Array, kKey, phrase(TRANSLATE_NOOP("problem", "a list of six numbers")), findings))
    return;
  if (list.items.size() != kCounts)
    return findings.add(list, kKey,
                        phrase(TRANSLATE_NOOP("problem", "This must be a list of six numbers, one for each joint.")));
  arm::EncoderCounts counts{};
  for (std::size_t joint = 0; joint < kCounts; ++joint) {
    const Value& count = list.items[joint];
    if (count.kind == json::JsonKind::Null) continue;  // not measured
    counts[joint] = count.number;
    if (count.kind == json::JsonKind::Number && count.number >= 1.0 && std::isfinite(count.number)) continue;
    findings.add(
        count, std::string(kKey) + "[" + std::to_string(joint) + "]",
        phrase(TRANSLATE_NOOP("problem", "This must be a number of at least 1, or null where it was not measured.")));
  }
  model.counts_per_turn = counts;
}

void readPlaces(const Value& list, std::vector<Vec3>& places_mm, Findings& findings) {
  const std::string path = "provenance.places_mm";
  if (!isKind(list, json::JsonKind::Array, path, phrase(TRANSLATE_NOOP("problem", "a list of positions")), findings))
    return;
  for (std::size_t index = 0; index < list.items.size(); ++index) {
    Vec3 place_mm = Vec3::Zero();
    const std::string own_path = path + "[" + std::to_string(index) + "]";
    readNumber(list.items[index], own_path, place_mm, findings);
    if (!(place_mm.cwiseAbs().maxCoeff() <= kFurthest_mm))
      findings.add(list.items[index], own_path,
                   phrase(TRANSLATE_NOOP("problem", "Each coordinate must lie within 1e6 mm (1 km).")));
    places_mm.push_back(place_mm);
  }
}

void readProvenance(const Value& value, Provenance& provenance, Findings& findings) {
  if (!isKind(value, json::JsonKind::Object, "provenance",
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"device\": \"...\", ...}"}), findings))
    return;
  ObjectReader object(value, "provenance", phrase(TRANSLATE_NOOP("problem", "the origin of a model")), findings);
  readWords(object, "device", true, provenance.device);
  readWords(object, "serial", false, provenance.serial);
  readWords(object, "date", true, provenance.date);
  readWords(object, "program", false, provenance.program);
  readWords(object, "method", false, provenance.method);
  if (const Value* const rate = object.find("rate_hz")) {
    double rate_hz = kSlowest_Hz;
    json::readNumber(*rate, "provenance.rate_hz", rate_hz, findings);
    if (rate_hz >= kSlowest_Hz && rate_hz <= kFastest_Hz && rate_hz == std::floor(rate_hz))
      provenance.rate_hz = static_cast<int>(rate_hz);
    else
      findings.add(*rate, "provenance.rate_hz",
                   phrase(TRANSLATE_NOOP("problem", "This must be a whole number of ticks per second, at least 1.")));
  }
  if (const Value* const places = object.find("places_mm")) readPlaces(*places, provenance.places_mm, findings);
  object.finish();
}

ModelUncertainty readUncertainty(const Value& value, Findings& findings) {
  ModelUncertainty uncertainty;
  if (!isKind(value, json::JsonKind::Object, "uncertainty",
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"mass_kg\": 0.001}"}), findings))
    return uncertainty;
  ObjectReader object(value, "uncertainty", phrase(TRANSLATE_NOOP("problem", "an uncertainty")), findings);
  readAmountUpTo(object, "mass_kg", false, kMax, uncertainty.mass_kg);
  readAmountUpTo(object, "friction_N", false, kMax, uncertainty.friction_N);
  readAmountUpTo(object, "damping_N_s_per_m", false, kMax, uncertainty.damping_N_s_per_m);
  object.finish();
  return uncertainty;
}

void readVersion(ObjectReader& object) {
  const Value* const version = object.find("underact_arm_model", true);
  if (version == nullptr || (version->kind == json::JsonKind::Number && version->number == 1.0)) return;
  object.findings().add(*version, "underact_arm_model",
                        phrase(TRANSLATE_NOOP("problem", "This program reads version 1 of arm models.")));
}

ArmModelFile readWhole(const Value& root, Findings& findings) {
  ArmModelFile file;
  ObjectReader object(root, "", phrase(TRANSLATE_NOOP("problem", "an arm model")), findings);
  readVersion(object);
  readWords(object, "name", true, file.arm.name);
  readWords(object, "title", true, file.arm.title);
  if (const Value* const value = object.find("provenance", true)) readProvenance(*value, file.provenance, findings);
  readAmountUpTo(object, "mass_kg", true, kHeaviest_kg, file.arm.mass_kg);
  readAmountUpTo(object, "friction_N", true, kMax, file.arm.friction_N);
  readAmountUpTo(object, "damping_N_s_per_m", false, kMax, file.arm.damping_N_s_per_m);
  if (const Value* const encoders = object.find("encoders")) {
    if (isKind(*encoders, json::JsonKind::Bool, "encoders", "true or false", findings))
      file.arm.encoders = encoders->boolean;
  }
  if (const Value* const counts = object.find("counts_per_turn")) readCounts(*counts, file.arm, findings);
  if (const Value* const value = object.find("uncertainty")) file.uncertainty = readUncertainty(*value, findings);
  object.finish();
  file.arm.provenance = sentenceOf(file.provenance);
  return file;
}

std::string placesText(const std::vector<Vec3>& places_mm) {
  std::string text;
  for (const Vec3& p_mm : places_mm)
    text += (text.empty() ? "[" : ", [") + numberText(p_mm.x()) + ", " + numberText(p_mm.y()) + ", " +
            numberText(p_mm.z()) + "]";
  return "[" + text + "]";
}

std::string provenanceText(const Provenance& from) {
  std::string text = "{\n    \"device\": " + quotedText(from.device);
  const auto add = [&text](const char* key, const std::string& value) {
    if (!value.empty()) text += ",\n    " + quotedText(key) + ": " + value;
  };
  const auto words = [](const std::string& value) { return value.empty() ? value : quotedText(value); };
  add("serial", words(from.serial));
  add("date", quotedText(from.date));
  add("program", words(from.program));
  add("method", words(from.method));
  add("rate_hz", from.rate_hz > 0 ? std::to_string(from.rate_hz) : "");
  add("places_mm", from.places_mm.empty() ? "" : placesText(from.places_mm));
  return text + "\n  }";
}

}  // namespace

Result<ArmModelFile> readArmModel(std::string_view text, const std::string& file_name) {
  const Result<Value> root = json::parse(text, file_name);
  if (!root) return root.problems();
  Findings findings(file_name);
  if (!isKind(root.value(), json::JsonKind::Object, "",
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"underact_arm_model\": 1, ...}"}), findings))
    return findings.take();
  ArmModelFile file = readWhole(root.value(), findings);
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return file;
}

Result<ArmModelFile> readArmModelFile(const std::string& path) {
  const Result<std::string> text = json::readTextFile(path, phrase(TRANSLATE_NOOP("problem", "an arm model")));
  if (!text) return text.problems();
  return readArmModel(text.value(), path);
}

std::string armModelText(const ArmModelFile& file) {
  const ArmModel& arm = file.arm;
  std::string text = "{\n  \"underact_arm_model\": 1";
  const auto add = [&text](const char* key, const std::string& value) {
    text += ",\n  " + quotedText(key) + ": " + value;
  };
  add("name", quotedText(arm.name));
  add("title", quotedText(arm.title));
  add("provenance", provenanceText(file.provenance));
  add("mass_kg", numberText(arm.mass_kg));
  add("friction_N", numberText(arm.friction_N));
  add("damping_N_s_per_m", numberText(arm.damping_N_s_per_m));
  if (!arm.encoders) add("encoders", "false");
  if (arm.counts_per_turn) {
    std::string counts;
    for (const double count : std::span(*arm.counts_per_turn).first<kCounts>())
      counts += (counts.empty() ? "" : ", ") + (count > 0.0 ? numberText(count) : std::string("null"));
    add("counts_per_turn", "[" + counts + "]");
  }
  if (file.uncertainty)
    add("uncertainty", "{\"mass_kg\": " + numberText(file.uncertainty->mass_kg) +
                           ", \"friction_N\": " + numberText(file.uncertainty->friction_N) +
                           ", \"damping_N_s_per_m\": " + numberText(file.uncertainty->damping_N_s_per_m) + "}");
  return text + "\n}\n";
}

std::string sentenceOf(const Provenance& provenance) {
  std::string text = "Measured on " + provenance.device;
  if (!provenance.serial.empty()) text += ", serial " + provenance.serial;
  text += ", on " + provenance.date;
  if (provenance.rate_hz > 0) text += " at " + std::to_string(provenance.rate_hz) + " Hz";
  if (!provenance.program.empty()) text += " by " + provenance.program;
  text += ".";
  return provenance.method.empty() ? text : text + " " + provenance.method;
}

Result<ArmModel> chooseArmModel(const std::string& name) {
  if (name.find_first_of("./\\") != std::string::npos) {
    Result<ArmModelFile> read = readArmModelFile(name);
    if (!read) return read.problems();
    return std::move(read).value().arm;
  }
  if (const ArmModel* const found = findArmModel(name)) return *found;
  std::vector<std::string> names;
  for (const ArmModel& one : armModels()) names.push_back(one.name);
  return Problems{
      {phrase(TRANSLATE_NOOP("problem", "There is no arm model %1; use %2, or a file (a name with a dot or a slash)."),
              {json::shown(name), json::listed(names)})}};
}

}  // namespace underact::sim
