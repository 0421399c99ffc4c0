#include "core/arm/joint_reader.h"

#include <cmath>

#include "core/arm/file_values.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/chain/dh_from_chain.h"
#include "core/chain/kinematics.h"

namespace underact::arm {
namespace {

using json::Findings;
using json::ObjectReader;
using json::Value;

constexpr json::Word<chain::JointType> kTypes[] = {{"revolute", chain::JointType::Revolute},
                                                   {"prismatic", chain::JointType::Prismatic}};
constexpr json::Word<ArmForm> kConventions[] = {{"modified", ArmForm::ModifiedDh}, {"classic", ArmForm::ClassicDh}};

/// A joint of either form, before it is placed.
struct JointLines {
  chain::JointType type = chain::JointType::Revolute;
  double min = -kInfinity, max = kInfinity;
  JointFacts facts;
  bool says_driven = false;
  LinkMass mass;  // in the link's frame
  bool has_mass = false;
};

/// One limit: the key of the joint's unit, or of degrees; those of the other type are refused with the reason.
double limitAt(ObjectReader& object, const std::string& which, bool turns, double otherwise) {
  const std::string rad = which + "_rad", deg = which + "_deg", mm = which + "_mm";
  if (!turns) {
    const Sentence why = phrase(TRANSLATE_NOOP("problem", "A prismatic joint has its limits in mm: \"%1\"."), {mm});
    object.refuse(rad, why);
    object.refuse(deg, why);
    const Value* const value = object.find(mm.c_str());
    return value == nullptr ? otherwise : lengthAt(object, mm.c_str(), false);
  }
  object.refuse(
      mm, phrase(TRANSLATE_NOOP("problem", "A revolute joint has its limits in degrees or radians: \"%1\"."), {deg}));
  const Value* const in_rad = object.find(rad.c_str());
  const Value* const in_deg = object.find(deg.c_str());
  if (in_rad != nullptr && in_deg != nullptr) {
    object.findings().add(*in_rad, object.pathOf(rad),
                          phrase(TRANSLATE_NOOP("problem", "This limit is already given by \"%1\"."), {deg}));
    numberAt(object, rad.c_str(), false);
  }
  if (in_deg != nullptr) return kRadPerDegree * numberAt(object, deg.c_str(), false);
  return numberAt(object, rad.c_str(), false, otherwise);
}

/// Where a joint rests.
std::optional<double> restAt(ObjectReader& object, bool turns) {
  const char* const key = turns ? "rest_deg" : "rest_mm";
  object.refuse(turns ? "rest_mm" : "rest_deg",
                turns ? phrase(TRANSLATE_NOOP("problem", "A revolute joint rests at an angle: \"%1\"."), {key})
                      : phrase(TRANSLATE_NOOP("problem", "A prismatic joint rests at a length: \"%1\"."), {key}));
  const json::Value* const in_rad = turns ? object.find("rest_rad") : nullptr;
  if (in_rad != nullptr && object.find(key) != nullptr) {
    object.findings().add(*in_rad, object.pathOf("rest_rad"),
                          phrase(TRANSLATE_NOOP("problem", "The rest is already given by \"%1\"."), {key}));
  }
  if (in_rad != nullptr) return numberAt(object, "rest_rad", false);
  if (object.find(key) == nullptr) return {};
  return turns ? kRadPerDegree * numberAt(object, key, false) : lengthAt(object, key, false);
}

/// The most that its motor gives.
std::optional<double> torqueAt(ObjectReader& object, bool turns) {
  const char *const key = turns ? "max_torque_N_m" : "max_force_N", *const other =
                                                                        turns ? "max_force_N" : "max_torque_N_m";
  object.refuse(other, turns ? phrase(TRANSLATE_NOOP("problem", "A revolute joint has a torque: \"%1\"."), {key})
                             : phrase(TRANSLATE_NOOP("problem", "A prismatic joint has a force: \"%1\"."), {key}));
  const json::Value* const value = object.find(key);
  if (value == nullptr) return {};
  const double max = numberAt(object, key, false, 1.0);
  if (!(max > 0.0))
    object.findings().add(*value, object.pathOf(key), phrase(TRANSLATE_NOOP("problem", "This must be above 0.")));
  return max;
}

/// Mass, centre and inertia of a link, in its frame.
bool readMass(ObjectReader& joint, LinkMass& mass) {
  const Value* const value = joint.find("mass");
  if (value == nullptr) return false;
  const std::string path = joint.pathOf("mass");
  if (!isKind(*value, json::JsonKind::Object, path, phrase(TRANSLATE_NOOP("problem", "an object in { }")),
              joint.findings()))
    return false;
  ObjectReader object(*value, path, phrase(TRANSLATE_NOOP("problem", "the mass of a link")), joint.findings());
  mass.mass_kg = numberAt(object, "mass_kg", true, 1.0);
  if (!(mass.mass_kg >= 0.0))
    object.findings().add(*value, object.pathOf("mass_kg"),
                          phrase(TRANSLATE_NOOP("problem", "This must be 0 or above.")));
  mass.p_WC = pointAt(object, "center_mm", false);
  if (const Value* const list = object.find("inertia_kg_mm2")) {
    const std::string key = object.pathOf("inertia_kg_mm2");
    std::array<double, 6> six{};
    bool whole = list->kind == json::JsonKind::Array && list->items.size() == six.size();
    for (std::size_t i = 0; whole && i < six.size(); ++i) {
      whole = list->items[i].kind == json::JsonKind::Number && std::isfinite(list->items[i].number);
      six[i] = list->items[i].number;
    }
    if (!whole) {
      object.findings().add(*list, key,
                            phrase(TRANSLATE_NOOP("problem", "This must be six numbers: xx, yy, zz, xy, xz and yz.")));
    } else {
      mass.inertia_W_kg_m2 << six[0], six[3], six[4], six[3], six[1], six[5], six[4], six[5], six[2];
      mass.inertia_W_kg_m2 *= kMetrePerMillimetre * kMetrePerMillimetre;
    }
  }
  object.finish();
  return true;
}

/// The keys that every joint can have.
JointLines readLines(ObjectReader& object, const Value& value, const std::string& path) {
  JointLines joint;
  Findings& findings = object.findings();
  if (const Value* const type = object.find("type"))
    json::readWord(*type, object.pathOf("type"), kTypes, joint.type, findings);
  const bool turns = joint.type == chain::JointType::Revolute;
  joint.min = limitAt(object, "min", turns, -kInfinity);
  joint.max = limitAt(object, "max", turns, kInfinity);
  if (!(joint.min < joint.max))
    findings.add(value, path,
                 phrase(TRANSLATE_NOOP("problem", "The joint's lower limit must be below its upper limit.")));
  joint.facts.rest = restAt(object, turns);
  if (joint.facts.rest && !(*joint.facts.rest >= joint.min && *joint.facts.rest <= joint.max))
    findings.add(value, path, phrase(TRANSLATE_NOOP("problem", "The joint's rest must be within its limits.")));
  joint.facts.max_torque = torqueAt(object, turns);
  if (const Value* const name = object.find("name"))
    json::readText(*name, object.pathOf("name"), joint.facts.name, findings);
  joint.says_driven = object.find("driven") != nullptr;
  joint.facts.driven = flagAt(object, "driven", true);
  joint.facts.sensed = flagAt(object, "sensed", true);
  if (joint.says_driven && joint.facts.driven && !joint.facts.sensed)
    findings.add(value, object.pathOf("driven"),
                 phrase(TRANSLATE_NOOP("problem", "A joint that is not sensed cannot be driven.")));
  if (!joint.facts.sensed) joint.facts.driven = false;
  joint.has_mass = readMass(object, joint.mass);
  return joint;
}

chain::DhRow readRow(ObjectReader& object) {
  chain::DhRow row;
  row.alpha_rad = kRadPerDegree * numberAt(object, "alpha_deg", true);
  row.a_m = lengthAt(object, "a_mm");
  row.theta_rad = kRadPerDegree * numberAt(object, "theta_deg", false);
  row.d_m = lengthAt(object, "d_mm");
  return row;
}

void readSizeLimits(ObjectReader& object, std::size_t index, Model& model) {
  const Value* const of_size = object.find("limits_of_size");
  if (of_size == nullptr) return;
  const bool is_limited_by_size = flagAt(object, "limits_of_size", false);
  if (is_limited_by_size && index != 4) {
    object.findings().add(
        *of_size, object.pathOf("limits_of_size"),
        phrase(TRANSLATE_NOOP("problem", "Only joint 5 can have limits on the magnitude of its angle.")));
  }
  model.limits_wrist_size |= is_limited_by_size;
}

chain::Joint readScrew(ObjectReader& object, const JointLines& lines) {
  chain::Joint joint{lines.type, Vec3::UnitZ(), Vec3::Zero(), lines.min, lines.max};
  if (const Value* const axis = object.find("axis", true)) {
    json::readNumber(*axis, object.pathOf("axis"), joint.axis_W, object.findings());
    const double length = joint.axis_W.stableNorm();
    if (!(length > 0.0 && std::isfinite(length))) {
      object.findings().add(*axis, object.pathOf("axis"),
                            phrase(TRANSLATE_NOOP("problem", "The axis has no direction.")));
      joint.axis_W = Vec3::UnitZ();
    } else {
      joint.axis_W /= length;
    }
  }
  if (lines.type == chain::JointType::Prismatic) {
    object.refuse("point_mm", phrase(TRANSLATE_NOOP("problem", "A prismatic joint has a direction, but no point.")));
  } else {
    joint.p_WJ = pointAt(object, "point_mm", true);
  }
  return joint;
}

/// The list of joints, of at least one and at most kMaxJoints; null: a problem.
const Value* listAt(ObjectReader& object, const char* key) {
  const Value* const list = object.find(key, true);
  if (list == nullptr || !isKind(*list, json::JsonKind::Array, key,
                                 phrase(TRANSLATE_NOOP("problem", "a list of joints, in { } each")), object.findings()))
    return nullptr;
  const std::size_t count = list->items.size();
  if (count >= 1 && count <= kMaxJoints) return list;
  object.findings().add(*list, key,
                        phrase(TRANSLATE_NOOP("problem", "An arm has from one to eight joints; this one has %1."),
                               {std::to_string(count)}));
  return nullptr;
}

/// Reads each joint: calls each(reader, lines).
template <class Each>
void forEachJoint(const Value& list, const char* key, const Sentence& what, Findings& findings, Model& model,
                  std::vector<JointLines>& all, const Each& each) {
  for (std::size_t index = 0; index < list.items.size(); ++index) {
    const Value& value = list.items[index];
    const std::string path = key + ("[" + std::to_string(index) + "]");
    if (!isKind(value, json::JsonKind::Object, path,
                phrase(TRANSLATE_NOOP("problem", "a row, as in {\"alpha_deg\": 90, \"a_mm\": 0, ...}")), findings))
      continue;
    ObjectReader object(value, path, what, findings);
    all.push_back(readLines(object, value, path));
    each(object, all.back());
    readSizeLimits(object, index, model);
    object.finish();
    model.joints.push_back(all.back().facts);
  }
}

/// Masses of links' frames as they are in W with all joints at 0.
void placeMasses(const std::vector<JointLines>& all, std::span<const Pose> X_WLinks, Model& model) {
  bool any = false;
  for (const JointLines& joint : all) any |= joint.has_mass;
  if (!any) return;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Pose& X = X_WLinks[i];
    LinkMass mass = all[i].mass;
    mass.p_WC = X * mass.p_WC;
    mass.inertia_W_kg_m2 = X.linear() * mass.inertia_W_kg_m2 * X.linear().transpose();
    model.masses.push_back(mass);
  }
}

/// Classic rows, Rz(theta) Dz(d) Dx(a) Rx(alpha), as modified ones: each takes alpha and a of the row before it, and
/// the tool those of the last.
void fromClassic(Model& model) {
  double alpha_rad = 0.0, a_m = 0.0;
  for (chain::DhRow& row : model.rows) {
    std::swap(row.alpha_rad, alpha_rad);
    std::swap(row.a_m, a_m);
  }
  const Pose X_Last = chain::rowPose({chain::JointType::Revolute, alpha_rad, a_m}, 0.0);
  model.X_NT = X_Last * model.X_NT;
}

void readTable(ObjectReader& object, Model& model) {
  if (const Value* const word = object.find("convention"))
    json::readWord(*word, "convention", kConventions, model.form, object.findings());
  const Value* const list = listAt(object, "dh");
  readPose(object, "X_WB", true, model.X_WB, &model.notes);
  const Value *const six = object.find("X_6T"), *const any = object.find("X_NT");
  if (six != nullptr && any != nullptr)
    object.findings().add(*any, "X_NT", phrase(TRANSLATE_NOOP("problem", "The tool is already given by \"X_6T\".")));
  if (six != nullptr && list != nullptr && list->items.size() != 6)
    object.findings().add(
        *six, "X_6T",
        phrase(
            TRANSLATE_NOOP("problem", "Only an arm of six joints can have \"X_6T\"; its general name is \"X_NT\".")));
  readPose(object, six != nullptr ? "X_6T" : "X_NT", false, model.X_NT, &model.notes);
  if (list == nullptr) return;
  std::vector<JointLines> all;
  const auto row = [&](ObjectReader& joint, const JointLines& lines) {
    chain::DhRow one = readRow(joint);
    one.type = lines.type, one.min = lines.min, one.max = lines.max;
    model.rows.push_back(one);
  };
  forEachJoint(*list, "dh", phrase(TRANSLATE_NOOP("problem", "a row of the DH table")), object.findings(), model, all,
               row);
  if (model.rows.size() != list->items.size()) return;  // told already
  const bool classic = model.form == ArmForm::ClassicDh;
  // A link's frame is the one after its row; a classic row ends in alpha and a, which a modified one leaves to the
  // next.
  std::vector<Pose> after(model.rows.size(), Pose::Identity());
  for (std::size_t i = 0; classic && i < after.size(); ++i)
    after[i] = chain::rowPose({chain::JointType::Revolute, model.rows[i].alpha_rad, model.rows[i].a_m}, 0.0);
  if (classic) fromClassic(model);
  model.chain = chain::chainFromDh(model.rows, model.X_WB, model.X_NT);
  const std::vector<double> home(model.rows.size(), 0.0);
  std::vector<Pose> frames(model.rows.size(), Pose::Identity());
  chain::framesOf(model.rows, model.X_WB, home, frames);
  for (std::size_t i = 0; classic && i < frames.size(); ++i) frames[i] = frames[i] * after[i];
  placeMasses(all, frames, model);
}

void readScrews(ObjectReader& object, Model& model) {
  model.form = ArmForm::Exponentials;
  const Value* const list = listAt(object, "joints");
  readPose(object, "X_WT_home", true, model.chain.X_WT_home, &model.notes);
  if (list == nullptr) return;
  std::vector<JointLines> all;
  const auto screw = [&](ObjectReader& joint, const JointLines& lines) {
    model.chain.joints.push_back(readScrew(joint, lines));
  };
  forEachJoint(*list, "joints", phrase(TRANSLATE_NOOP("problem", "a joint")), object.findings(), model, all, screw);
  if (model.chain.joints.size() != list->items.size()) return;
  placeMasses(all, std::vector<Pose>(all.size(), Pose::Identity()), model);
  setTable(model);
}

}  // namespace

void setTable(Model& model) {
  const chain::DhForm form = chain::dhOf(model.chain);
  model.rows = form.rows;
  model.X_WB = form.X_WB;
  model.X_NT = form.X_NT;
}

void readJoints(ObjectReader& object, Model& model) {
  const Value* const screws = object.find("joints");
  const Value* const table = object.find("dh");
  if (screws != nullptr && table != nullptr) {
    object.findings().add(*screws, "joints",
                          phrase(TRANSLATE_NOOP("problem", "The joints are already given by the table \"dh\".")));
  }
  if (screws != nullptr && table == nullptr) {
    readScrews(object, model);
  } else {
    readTable(object, model);
  }
}

}  // namespace underact::arm
