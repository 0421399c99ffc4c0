#include <optional>
#include <utility>

#include "app/sweeper/catalogue.h"
#include "app/sweeper/request.h"
#include "core/json/object_reader.h"
#include "core/json/text.h"

namespace underact::sweep {
namespace {

using json::Findings;
using json::Value;

constexpr double kLargestSeed = 0x1p53;  // beyond it a double skips whole numbers

/// A value as on the command line; none, and a problem, if it is neither text nor a number.
std::optional<std::string> wordOf(const Value& value, const std::string& path, Findings& findings) {
  if (value.kind == json::JsonKind::String) return value.text;
  if (value.kind == json::JsonKind::Number) return json::numberText(value.number);
  findings.add(value, path, "This must be a text or a number.");
  return {};
}

void readOptions(const Value& object, Options::Values& values, Findings& findings) {
  if (!isKind(object, json::JsonKind::Object, "options", "an object, as in {\"draws\": 10}", findings)) return;
  for (std::size_t member = 0; member < object.keys.size(); ++member) {
    const std::string path = "options." + json::plainKey(object.keys[member]);
    const Value& value = object.items[member];
    const bool is_list = value.kind == json::JsonKind::Array;
    const auto [at, is_first] = values.try_emplace(object.keys[member]);
    if (!is_first) findings.add(object.key_places[member], path, "This key appears twice.");
    for (const Value& item : is_list ? value.items : std::vector{value}) {
      if (std::optional<std::string> word = wordOf(item, path, findings)) at->second.push_back(std::move(*word));
    }
  }
}

void readRoot(const Value& root, Request& request, Findings& findings) {
  if (!isKind(root, json::JsonKind::Object, "", "an object, as in {\"underact_sweep\": 1, ...}", findings)) return;
  json::ObjectReader object(root, "", "a sweep", findings);
  if (const Value* version = object.find("underact_sweep", true); version != nullptr && version->number != 1.0)
    findings.add(*version, "underact_sweep", "This must be 1, the only version.");
  if (const Value* kind = object.find("kind", true)) {
    std::string key;
    readText(*kind, "kind", key, findings);
    request.kind = findKind(key);
    std::vector<std::string> keys;
    for (const SweepKind& one : kinds()) keys.push_back(one.key);
    if (request.kind == nullptr && kind->kind == json::JsonKind::String)
      findings.add(*kind, "kind", "This must be " + json::listed(keys) + "; here it is " + json::shown(key) + ".");
  }
  if (const Value* seed = object.find("seed")) {
    double number = 0.0;
    readNumber(*seed, "seed", number, findings);
    const bool is_seed =
        number >= 0.0 && number <= kLargestSeed && number == static_cast<double>(static_cast<std::uint64_t>(number));
    if (is_seed)
      request.seed = static_cast<std::uint64_t>(number);
    else
      findings.add(*seed, "seed", "This must be a whole number from 0 to 2^53.");
  }
  if (const Value* options = object.find("options", true)) readOptions(*options, request.values, findings);
  object.finish();
}

}  // namespace

void readRequest(const std::string& path, Request& request) {
  const Result<std::string> text = json::readTextFile(path, "a sweep");
  const Result<Value> root = text ? json::parse(text.value(), path) : text.problems();
  if (!root) {
    request.problems = root.problems();
    return;
  }
  Findings findings(path);
  readRoot(root.value(), request, findings);
  request.problems = findings.take();
}

}  // namespace underact::sweep
