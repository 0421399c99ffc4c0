#include "core/arm/arm_text.h"

#include <tinyxml2.h>

#include <cmath>

#include "core/arm/file_values.h"
#include "core/arm/solid_file.h"
#include "core/base/translate.h"
#include "core/base/trig.h"
#include "core/base/units.h"
#include "core/chain/dh_from_chain.h"
#include "core/json/json.h"

namespace underact::arm {
namespace {

using json::numberText;
using json::quotedText;

constexpr double kLost_m = 1e-12, kLost_rad = 1e-12;

std::string listText(std::span<const double> numbers, double factor = 1.0) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "[" : ", ") + numberText(number * factor);
  return text + "]";
}

/// Limits, name, motor and mass of a joint, each after a comma. X_WLink: the frame of the masses.
std::string moreOf(const Model& model, std::size_t i, const Pose& X_WLink) {
  const chain::Joint& joint = model.chain.joints[i];
  const bool turns = joint.type == chain::JointType::Revolute;
  std::string text;
  for (const auto& [key, limit] : {std::pair{"min", joint.min}, {"max", joint.max}}) {
    if (!std::isfinite(limit)) continue;
    text += std::string(", \"") + key + (turns ? "_rad" : "_mm") +
            "\": " + numberText(turns ? limit : kMillimetrePerMetre * limit);
  }
  if (model.limits_wrist_size && i == 4) text += ", \"limits_of_size\": true";
  const JointFacts& facts = model.joints[i];
  if (facts.rest) {
    text += turns ? ", \"rest_rad\": " + numberText(*facts.rest)
                  : ", \"rest_mm\": " + numberText(kMillimetrePerMetre * *facts.rest);
  }
  if (facts.max_torque)
    text += std::string(", \"") + (turns ? "max_torque_N_m" : "max_force_N") + "\": " + numberText(*facts.max_torque);
  if (!facts.name.empty()) text += ", \"name\": " + quotedText(facts.name);
  if (!facts.driven) text += ", \"driven\": false";
  if (!facts.sensed) text += ", \"sensed\": false";
  if (model.masses.empty()) return text;
  const LinkMass& mass = model.masses[i];
  const Vec3 p = kMillimetrePerMetre * (X_WLink.inverse(Eigen::Isometry) * mass.p_WC);
  const Mat3 I = X_WLink.linear().transpose() * mass.inertia_W_kg_m2 * X_WLink.linear() * 1e6;
  const std::array<double, 6> six{I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
  return text + ", \"mass\": {\"mass_kg\": " + numberText(mass.mass_kg) +
         ", \"center_mm\": " + listText({p.data(), 3}) + ", \"inertia_kg_mm2\": " + listText(six) + "}";
}

std::string headOf(const Model& model) {
  return "{\n  \"underact_arm\": 1,\n  \"name\": " + quotedText(model.name) +
         ",\n  \"title\": " + quotedText(model.title) + ",\n  \"provenance\": " + quotedText(model.provenance) + ",\n";
}

const char* typeText(const chain::Joint& joint) {
  return joint.type == chain::JointType::Revolute ? "revolute" : "prismatic";
}

Result<std::string> tableText(const Model& model) {
  const chain::DhForm form = chain::dhOf(model.chain);
  const bool given = model.form == ArmForm::ModifiedDh || model.form == ArmForm::ClassicDh;
  if (!given && !(form.error_m <= kLost_m && form.error_rad <= kLost_rad)) {
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "Two of the axes are nearly parallel: a DH table would lose digits. Write the arm "
                               "as a product of exponentials (poe)."))}};
  }
  std::vector<Pose> frames(model.rows.size(), Pose::Identity());
  chain::framesOf(model.rows, model.X_WB, std::vector<double>(model.rows.size(), 0.0), frames);
  std::string text = headOf(model) + "  \"dh\": [\n";
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    const chain::DhRow& row = model.rows[i];
    text += std::string("    {\"type\": \"") + typeText(model.chain.joints[i]) +
            "\", \"alpha_deg\": " + numberText(row.alpha_rad / kRadPerDegree) +
            ", \"a_mm\": " + numberText(kMillimetrePerMetre * row.a_m) +
            ", \"theta_deg\": " + numberText(row.theta_rad / kRadPerDegree) +
            ", \"d_mm\": " + numberText(kMillimetrePerMetre * row.d_m) + moreOf(model, i, frames[i]) +
            (i + 1 < model.rows.size() ? "},\n" : "}\n");
  }
  text += "  ],\n  \"X_WB\": " + poseText(model.X_WB) + ",\n  \"X_NT\": " + poseText(model.X_NT) + solidsText(model);
  if (model.device) {
    const std::span<const double> counts(model.device->counts_per_turn.data(), model.joints.size());
    const bool stated = std::any_of(counts.begin(), counts.end(), [](double count) { return count > 0.0; });
    text += ",\n  \"device\": {" + (stated ? "\"encoder_counts_per_turn\": " + listText(counts) + ", " : "") +
            "\"continuous_force_N\": " + numberText(model.device->continuous_force_N);
    const double moment_N_m = model.device->continuous_moment_N_m;
    text += (moment_N_m > 0.0 ? ", \"continuous_moment_N_m\": " + numberText(moment_N_m) : "") + "}";
  }
  return text + "\n}\n";
}

Result<std::string> screwsText(const Model& model) {
  if (model.device)
    return Problems{{phrase(
        TRANSLATE_NOOP("problem", "A haptic device must stay a DH table, because its lengths are read from that."))}};
  std::string text = headOf(model) + "  \"joints\": [\n";
  for (std::size_t i = 0; i < model.chain.joints.size(); ++i) {
    const chain::Joint& joint = model.chain.joints[i];
    text += std::string("    {\"type\": \"") + typeText(joint) + "\", \"axis\": " + listText({joint.axis_W.data(), 3});
    if (joint.type == chain::JointType::Revolute)
      text += ", \"point_mm\": " + listText({joint.p_WJ.data(), 3}, kMillimetrePerMetre);
    text += moreOf(model, i, Pose::Identity()) + (i + 1 < model.chain.joints.size() ? "},\n" : "}\n");
  }
  return text + "  ],\n  \"X_WT_home\": " + poseText(model.chain.X_WT_home) + solidsText(model) + "\n}\n";
}

/// Roll, pitch and yaw of a rotation: fixed axes x, y, z. Source: Craig, eq. 2.66 and 2.67.
Vec3 anglesOf(const Mat3& R) {
  const double across = std::sqrt(R(0, 0) * R(0, 0) + R(1, 0) * R(1, 0));
  if (across < 1e-12) return {atan2Of(-R(1, 2), R(1, 1)), atan2Of(-R(2, 0), across), 0.0};
  return {atan2Of(R(2, 1), R(2, 2)), atan2Of(-R(2, 0), across), atan2Of(R(1, 0), R(0, 0))};
}

std::string wordsOf(const Vec3& numbers) {
  const auto word = [](double number) { return numberText(number == 0.0 ? 0.0 : number); };
  return word(numbers.x()) + " " + word(numbers.y()) + " " + word(numbers.z());
}

/// Writes a robot whose links have the axes of W at home, so that no joint needs an orientation.
class UrdfWriter {
 public:
  explicit UrdfWriter(const Model& model) : model_(model) {}

  std::string text() {
    printer_.OpenElement("robot");
    printer_.PushAttribute("name", model_.name.c_str());
    link("base_link", 0, Vec3::Zero());
    Vec3 p_WLast = Vec3::Zero();
    std::string last = "base_link";
    for (std::size_t i = 0; i < model_.chain.joints.size(); ++i) {
      const chain::Joint& joint = model_.chain.joints[i];
      // A slide has no point of its own: its link stays with the one before.
      const Vec3 p_WLink = joint.type == chain::JointType::Revolute ? joint.p_WJ : p_WLast;
      const std::string name = "link" + std::to_string(i + 1);
      link(name, i + 1, p_WLink);
      open(nameOf(i), kindOf(joint), last, name, p_WLink - p_WLast, Vec3::Zero());
      child("axis", {{"xyz", wordsOf(joint.axis_W)}});
      if (std::isfinite(joint.min))
        child("limit",
              {{"lower", numberText(joint.min)}, {"upper", numberText(joint.max)}, {"effort", "0"}, {"velocity", "0"}});
      printer_.CloseElement();
      p_WLast = p_WLink, last = name;
    }
    link("tip", model_.chain.joints.size() + 1, Vec3::Zero());
    const Pose& X = model_.chain.X_WT_home;
    open("tool", "fixed", last, "tip", X.translation() - p_WLast, anglesOf(X.linear()));
    printer_.CloseElement();
    printer_.CloseElement();
    return std::string("<?xml version=\"1.0\"?>\n") + printer_.CStr();
  }

 private:
  using Attributes = std::vector<std::pair<const char*, std::string>>;
  void child(const char* name, const Attributes& attributes) {
    printer_.OpenElement(name);
    for (const auto& [key, value] : attributes) printer_.PushAttribute(key, value.c_str());
    printer_.CloseElement();
  }
  std::string nameOf(std::size_t i) const {
    const std::string number = "joint" + std::to_string(i + 1), &name = model_.joints[i].name;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      if (name.empty() || name == "tool" || (j != i && model_.joints[j].name == name)) return number;
    }
    return name;
  }
  static const char* kindOf(const chain::Joint& joint) {
    if (joint.type == chain::JointType::Prismatic) return "prismatic";
    return std::isfinite(joint.min) ? "revolute" : "continuous";
  }
  /// index: 0 the base, i what joint i moves, one more the tip, which has nothing of its own.
  void link(const std::string& name, std::size_t index, const Vec3& p_WLink) {
    printer_.OpenElement("link");
    printer_.PushAttribute("name", name.c_str());
    for (const LinkSolid& solid : model_.solids) {
      if (solid.link == index) visual(solid, p_WLink);
    }
    if (index > 0 && index <= model_.masses.size()) {
      const LinkMass* const mass = &model_.masses[index - 1];
      const Mat3& I = mass->inertia_W_kg_m2;
      printer_.OpenElement("inertial");
      child("origin", {{"xyz", wordsOf(mass->p_WC - p_WLink)}});
      child("mass", {{"value", numberText(mass->mass_kg)}});
      child("inertia", {{"ixx", numberText(I(0, 0))},
                        {"ixy", numberText(I(0, 1))},
                        {"ixz", numberText(I(0, 2))},
                        {"iyy", numberText(I(1, 1))},
                        {"iyz", numberText(I(1, 2))},
                        {"izz", numberText(I(2, 2))}});
      printer_.CloseElement();
    }
    printer_.CloseElement();
  }
  void visual(const LinkSolid& solid, const Vec3& p_WLink) {
    printer_.OpenElement("visual");
    child("origin",
          {{"xyz", wordsOf(solid.X_WS.translation() - p_WLink)}, {"rpy", wordsOf(anglesOf(solid.X_WS.linear()))}});
    printer_.OpenElement("geometry");
    if (const auto* const box = std::get_if<BoxSolid>(&solid.form)) child("box", {{"size", wordsOf(box->size_m)}});
    if (const auto* const ball = std::get_if<SphereSolid>(&solid.form))
      child("sphere", {{"radius", numberText(ball->radius_m)}});
    if (const auto* const rod = std::get_if<CylinderSolid>(&solid.form))
      child("cylinder", {{"radius", numberText(rod->radius_m)}, {"length", numberText(rod->length_m)}});
    if (const auto* const mesh = std::get_if<MeshSolid>(&solid.form))
      child("mesh", {{"filename", mesh->name}, {"scale", wordsOf(mesh->m_per_unit)}});
    printer_.CloseElement();
    printer_.CloseElement();
  }
  void open(const std::string& name, const char* type, const std::string& parent, const std::string& child_name,
            const Vec3& xyz, const Vec3& rpy) {
    printer_.OpenElement("joint");
    printer_.PushAttribute("name", name.c_str());
    printer_.PushAttribute("type", type);
    child("parent", {{"link", parent}});
    child("child", {{"link", child_name}});
    child("origin", {{"xyz", wordsOf(xyz)}, {"rpy", wordsOf(rpy)}});
  }

  const Model& model_;
  tinyxml2::XMLPrinter printer_;
};

Result<std::string> urdfText(const Model& model) {
  Problems problems;
  const auto say = [&](const char* sentence, std::size_t i) {
    problems.push_back({phrase(sentence, {std::to_string(i + 1)})});
  };
  for (std::size_t i = 0; i < model.chain.joints.size(); ++i) {
    const chain::Joint& joint = model.chain.joints[i];
    const bool bounded = std::isfinite(joint.min) && std::isfinite(joint.max);
    const bool unbounded = !std::isfinite(joint.min) && !std::isfinite(joint.max);
    if (joint.type == chain::JointType::Prismatic && !bounded)
      say(TRANSLATE_NOOP("problem", "Joint %1 slides without limits, which URDF cannot express."), i);
    if (joint.type == chain::JointType::Revolute && !bounded && !unbounded)
      say(TRANSLATE_NOOP("problem", "Joint %1 has one limit only, which URDF cannot express."), i);
    if (model.limits_wrist_size && i == 4)
      say(TRANSLATE_NOOP("problem", "Joint %1 has limits on the magnitude of its angle, which URDF cannot express."),
          i);
  }
  for (const LinkSolid& solid : model.solids) {
    if (!std::holds_alternative<CapsuleSolid>(solid.form)) continue;
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "A capsule is none of the forms of URDF."))});
    break;
  }
  if (!problems.empty()) return problems;
  return UrdfWriter(model).text();
}

}  // namespace

Result<std::string> textOf(const Model& model, ArmForm to) {
  if (to == ArmForm::Urdf) return urdfText(model);
  return to == ArmForm::Exponentials ? screwsText(model) : tableText(model);
}

}  // namespace underact::arm
