#include "device/simulated_run.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/base/translate.h"

namespace underact::device {
namespace {

using json::ObjectText;
using json::Value;

ObjectText pointObject(const sim::HandPoint& point) {
  ObjectText object;
  object.addNumber("t_s", point.t_s);
  object.addVector("p_m", point.p_WT);
  if (point.turns) object.addMatrix("R_WT", point.R_WT);
  return object;
}

ObjectText handObject(const SimulatedRun& run) {
  const sim::HandScript& hand = run.hand;
  ObjectText object;
  object.addText("name", run.hand_name);
  object.addText("seed", std::to_string(hand.seed));  // as text: a number of JSON has 53 bits for sure
  object.addNumber("mass_kg", hand.hand.mass_kg);
  object.addNumber("damping_N_s_per_m", hand.hand.damping_N_s_per_m);
  object.addNumber("stiffness_N_per_m", hand.hand.stiffness_N_per_m);
  object.addNumber("tremor_m", hand.tremor_m);
  object.addNumber("repeat_s", hand.repeat_s);
  std::vector<ObjectText> path;
  for (const sim::HandPoint& point : hand.path) path.push_back(pointObject(point));
  object.addList("path", path);
  if (!run.hand_file.empty()) object.addText("file", run.hand_file);
  return object;
}

ObjectText modelObject(const sim::ArmModel& model) {
  ObjectText object;
  object.addText("name", model.name);
  object.addText("title", model.title);
  object.addText("provenance", model.provenance);
  object.addNumber("mass_kg", model.mass_kg);
  object.addNumber("friction_N", model.friction_N);
  object.addNumber("damping_N_s_per_m", model.damping_N_s_per_m);
  object.addBool("encoders", model.encoders);
  if (model.of_links) object.addBool("of_links", true);
  if (model.counts_per_turn) object.addList("counts_per_turn", std::span<const double>(*model.counts_per_turn));
  return object;
}

/// Takes members out of an object; what is missing or of another kind is remembered.
class Taker {
 public:
  explicit Taker(const Value* object) : object_(object), is_good_(object != nullptr) {}
  const Value* find(const char* key, json::JsonKind kind) {
    const Value* const value = object_ != nullptr ? object_->find(key) : nullptr;
    if (value != nullptr && value->kind == kind) return value;
    is_good_ = false;
    return nullptr;
  }
  double number(const char* key) {
    const Value* const value = find(key, json::JsonKind::Number);
    return value != nullptr ? value->number : 0.0;
  }
  bool boolean(const char* key) {
    const Value* const value = find(key, json::JsonKind::Bool);
    return value != nullptr && value->boolean;
  }
  std::string text(const char* key) {
    const Value* const value = find(key, json::JsonKind::String);
    return value != nullptr ? value->text : std::string();
  }
  bool isGood() const { return is_good_; }

 private:
  const Value* object_;
  bool is_good_;
};

bool takeNumbers(const Value* list, double* numbers, std::size_t count) {
  if (list == nullptr || list->kind != json::JsonKind::Array || list->items.size() != count) return false;
  for (std::size_t index = 0; index < count; ++index) {
    if (list->items[index].kind != json::JsonKind::Number) return false;
    numbers[index] = list->items[index].number;
  }
  return true;
}

bool takePoint(const Value& value, sim::HandPoint& point) {
  Taker taker(&value);
  point.t_s = taker.number("t_s");
  bool good = takeNumbers(value.find("p_m"), point.p_WT.data(), 3);
  if (const Value* const rows = value.find("R_WT")) {
    point.turns = true;
    good = good && rows->kind == json::JsonKind::Array && rows->items.size() == 3;
    for (std::size_t row = 0; good && row < 3; ++row) {
      Vec3 numbers;
      good = takeNumbers(&rows->items[row], numbers.data(), 3);
      point.R_WT.row(static_cast<Eigen::Index>(row)) = numbers.transpose();
    }
  }
  return good && taker.isGood();
}

bool takeHand(const Value* object, SimulatedRun& run) {
  Taker taker(object);
  run.hand_name = taker.text("name");
  const std::string seed = taker.text("seed");
  const bool is_seed = std::from_chars(seed.data(), seed.data() + seed.size(), run.hand.seed).ec == std::errc();
  run.hand.hand = {taker.number("mass_kg"), taker.number("damping_N_s_per_m"), taker.number("stiffness_N_per_m")};
  run.hand.tremor_m = taker.number("tremor_m");
  run.hand.repeat_s = taker.number("repeat_s");
  const Value* const path = taker.find("path", json::JsonKind::Array);
  if (!taker.isGood() || !is_seed || path->items.empty()) return false;
  for (const Value& point : path->items) {
    if (!takePoint(point, run.hand.path.emplace_back())) return false;
    const std::size_t count = run.hand.path.size();
    if (count > 1 && !(run.hand.path[count - 1].t_s > run.hand.path[count - 2].t_s)) return false;
  }
  if (const Value* const file = object->find("file")) run.hand_file = file->text;
  return true;
}

bool takeModel(const Value* object, sim::ArmModel& model) {
  Taker taker(object);
  model.name = taker.text("name");
  model.title = taker.text("title");
  model.provenance = taker.text("provenance");
  model.mass_kg = taker.number("mass_kg");
  model.friction_N = taker.number("friction_N");
  model.damping_N_s_per_m = taker.number("damping_N_s_per_m");
  model.encoders = taker.boolean("encoders");
  if (!taker.isGood()) return false;
  if (object->find("of_links") != nullptr) model.of_links = taker.boolean("of_links");
  const Value* const counts = object->find("counts_per_turn");
  if (counts == nullptr) return true;
  return takeNumbers(counts, model.counts_per_turn.emplace().data(), model.counts_per_turn->size());
}

}  // namespace

ObjectText provenanceOf(const SimulatedRun& run) {
  ObjectText inner;
  inner.addText("made_by", "simulated arm");
  inner.addInteger("seed", run.seed);
  inner.addInteger("ticks", run.ticks);
  inner.addBool("fast", run.fast);
  inner.addObject("hand", handObject(run));
  inner.addObject("arm_model", modelObject(run.model));
  ObjectText object;
  object.addObject("run", inner);
  return object;
}

namespace {

ObjectText provenanceOfHand(const char* made_by, const sim::ArmModel* model) {
  ObjectText inner, object;
  inner.addText("made_by", made_by);
  if (model != nullptr) inner.addObject("arm_model", modelObject(*model));
  object.addObject("run", inner);
  return object;
}

}  // namespace

ObjectText provenanceOfPerson(const sim::ArmModel* model) {
  return provenanceOfHand("a person's hand", model);
}

ObjectText provenanceOfPython(const sim::ArmModel& model) {
  return provenanceOfHand("a hand in Python", &model);
}

ObjectText provenanceOfService(const SimulatedRun* run) {
  ObjectText inner, object;
  inner.addText("made_by", "live service");
  if (run != nullptr) {
    inner.addObject("held_by", handObject(*run));
    inner.addObject("arm_model", modelObject(run->model));
  }
  object.addObject("run", inner);
  return object;
}

bool hasSimulatedRun(const Value& provenance) {
  const Value* const run = provenance.find("run");
  return run != nullptr && run->find("hand") != nullptr && run->find("arm_model") != nullptr;
}

Result<SimulatedRun> readSimulatedRun(const Value& provenance, const std::string& file) {
  SimulatedRun run;
  const Value* const object = provenance.find("run");
  Taker taker(object);
  constexpr double kMaxTicks = 0x1p53;  // what JSON holds exactly
  run.ticks = static_cast<std::int64_t>(std::clamp(taker.number("ticks"), 0.0, kMaxTicks));
  run.fast = taker.boolean("fast");
  const double seed = taker.number("seed");
  if (!taker.isGood() || !takeHand(object->find("hand"), run) || !takeModel(object->find("arm_model"), run.model))
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "This session does not say completely by which hand and on which arm model it "
                               "was made: the file is damaged, or of a newer version.")),
         {file}}};
  // A number of JSON has 53 bits; the hand's seed, which is the run's, has all 64.
  if (seed == static_cast<double>(run.hand.seed))
    run.seed = run.hand.seed;
  else
    run.seed = static_cast<std::uint64_t>(std::clamp(seed, 0.0, 0x1p53));
  return run;
}

std::unique_ptr<SimulatedArm> makeSimulatedArm(const SimulatedRun& run, const arm::Preset& arm,
                                               const scene::Description& scene, int rate_hz) {
  SimulatedArm::Options options;
  options.arm = arm;
  options.model = run.model;
  options.hand = run.hand.hand;
  options.rate_hz = rate_hz;
  options.integration = integrationOf(scene.simulation);
  auto simulated = std::make_unique<SimulatedArm>(options);
  simulated->follow(run.hand);
  return simulated;
}

}  // namespace underact::device
