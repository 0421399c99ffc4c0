#include "core/arm/urdf.h"

#include <algorithm>
#include <optional>

#include "core/arm/joint_reader.h"
#include "core/arm/solid_place.h"
#include "core/arm/urdf_family.h"
#include "core/base/translate.h"
#include "core/json/json.h"
#include "core/json/text.h"

namespace underact::arm {
namespace {

/// Another mass on the same link.
void addTo(LinkMass& all, const LinkMass& one) {
  const double total_kg = all.mass_kg + one.mass_kg;
  if (!(total_kg > 0.0)) return;
  const Vec3 p_WC = (all.mass_kg * all.p_WC + one.mass_kg * one.p_WC) / total_kg;
  const auto about = [&](const LinkMass& mass) {  // Steiner's theorem
    const Vec3 offset = mass.p_WC - p_WC;
    return Mat3(mass.inertia_W_kg_m2 +
                mass.mass_kg * (offset.squaredNorm() * Mat3::Identity() - offset * offset.transpose()));
  };
  all = {total_kg, p_WC, Mat3(about(all) + about(one))};
}

/// Walks from base to tip: places each joint and mass in W, with all joints at 0.
class Walk {
 public:
  Walk(const UrdfTree& tree, LinkFamily& family, Model& model)
      : tree_(tree), family_(family), model_(model), seen_(tree.links.size(), false) {}

  void go(std::size_t base, const std::vector<UrdfStep>& steps) {
    for (const BodyLink& one : family_.bodyOf(base, true)) seen_[one.link] = true;
    show(tree_.links[base]);
    for (const UrdfStep& step : steps) pass(step);
    model_.chain.X_WT_home = X_WLink_;
    if (model_.solids.size() > kMaxSolids) model_.solids.clear();
    if (!any_mass_) model_.masses.clear();
    noteMassesBeside();
  }

 private:
  void pass(const UrdfStep& step) {
    const UrdfJoint& joint = tree_.joints[step.joint];
    if (step.down) X_WLink_ = X_WLink_ * joint.X_ParentJoint;
    add(joint, step);
    if (!step.down) X_WLink_ = X_WLink_ * joint.X_ParentJoint.inverse(Eigen::Isometry);
    const std::size_t link = family_.indexOf(step.down ? joint.child : joint.parent);
    show(tree_.links[link]);
    if (joint.motion != UrdfMotion::Fixed) carryBody(link);
  }

  /// What to do where an arm cannot have a joint: to end it before, or to begin behind.
  std::string wayRound(const UrdfJoint& joint, bool down) const {
    const std::string& before = down ? joint.parent : joint.child;
    const std::string& behind = down ? joint.child : joint.parent;
    return model_.joints.empty() ? "arm convert --base " + behind : "arm convert --tip " + before;
  }

  void add(const UrdfJoint& joint, const UrdfStep& step) {
    if (joint.motion == UrdfMotion::Fixed) return;
    if (joint.motion == UrdfMotion::Other)
      return family_.say(joint.line, "type",
                         phrase(TRANSLATE_NOOP("problem",
                                               "The joint %1 is %2; a joint of an arm turns about an axis or slides "
                                               "along it. Leave it out (%3)."),
                                {json::shown(joint.name), json::shown(joint.type), wayRound(joint, step.down)}));
    if (joint.follows)
      return family_.say(
          joint.line, "mimic",
          phrase(TRANSLATE_NOOP("problem",
                                "The joint %1 follows another one; each joint of an arm moves by itself. "
                                "Leave it out (%2)."),
                 {json::shown(joint.name), wayRound(joint, step.down)}));
    if (joint.lacks_limits)
      family_.note(
          joint.limit_line, "limit",
          phrase(TRANSLATE_NOOP("problem", "The joint %1 has no range here, and is taken as one without limits."),
                 {json::shown(joint.name)}));
    if (!(joint.min < joint.max))  // of a joint beside the way, such as a wheel, nobody asks
      family_.say(joint.limit_line, "lower",
                  phrase(TRANSLATE_NOOP("problem", "The joint's lower limit must be below its upper limit.")));
    const bool turns = joint.motion == UrdfMotion::Turns;
    if (model_.joints.size() == kMaxJoints)
      family_.say(joint.line, "joint",
                  phrase(TRANSLATE_NOOP("problem",
                                        "An arm has from one to eight joints; this is the ninth. End it before (%1)."),
                         {wayRound(joint, step.down)}));
    model_.chain.joints.push_back({turns ? chain::JointType::Revolute : chain::JointType::Prismatic,
                                   (step.down ? 1.0 : -1.0) * (X_WLink_.linear() * joint.axis).normalized(),
                                   X_WLink_.translation(), joint.min, joint.max});
    model_.joints.push_back({joint.name, true, true, {}});
    model_.masses.emplace_back();
  }

  void show(const UrdfLink& link) {
    model_.notes.insert(model_.notes.end(), link.notes.begin(), link.notes.end());
    for (const LinkSolid& solid : link.solids)
      model_.solids.push_back({model_.joints.size(), X_WLink_ * solid.X_WS, solid.form});
  }

  /// The masses of a link behind a joint, and of all that is fixed to it.
  void carryBody(std::size_t first) {
    for (const BodyLink& one : family_.bodyOf(first, true)) {
      seen_[one.link] = true;
      carried_.push_back(one.link);
      const std::optional<LinkMass>& mass = tree_.links[one.link].mass;
      if (!mass || model_.masses.empty()) continue;
      any_mass_ = true;
      const Pose X_WLink = X_WLink_ * one.X_FirstLink;
      const Mat3& R = X_WLink.linear();
      addTo(model_.masses.back(), {mass->mass_kg, X_WLink * mass->p_WC, R * mass->inertia_W_kg_m2 * R.transpose()});
    }
  }

  /// What moves on joints beside the way, a gripper's fingers for example, is no mass of one link of the arm.
  void noteMassesBeside() {
    double beside_kg = 0.0;
    std::size_t first = kNone;
    const auto look = [&](std::size_t link) {
      if (seen_[link]) return;
      seen_[link] = true;
      carried_.push_back(link);
      const double mass_kg = tree_.links[link].mass ? tree_.links[link].mass->mass_kg : 0.0;
      if (mass_kg > 0.0 && first == kNone) first = link;
      beside_kg += mass_kg;
    };
    for (std::size_t i = 0; i < carried_.size(); ++i) {
      const std::size_t at = carried_[i];
      for (const std::size_t joint : family_.below(at)) look(family_.indexOf(tree_.joints[joint].child));
      if (family_.above(at) != kNone) look(family_.indexOf(tree_.joints[family_.above(at)].parent));
    }
    if (first == kNone) return;
    family_.note(
        tree_.links[first].line, "mass",
        phrase(TRANSLATE_NOOP("problem", "%1 kg on joints beside the arm, from link %2 on, are in none of its masses."),
               {json::numberText(beside_kg), json::shown(tree_.links[first].name)}));
  }

  const UrdfTree& tree_;
  LinkFamily& family_;
  Model& model_;
  Pose X_WLink_ = Pose::Identity();
  std::vector<bool> seen_;            // links whose masses are counted, or of the base
  std::vector<std::size_t> carried_;  // links that joints of the arm carry
  bool any_mass_ = false;
};

}  // namespace

bool isUrdfText(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

Result<Model> readUrdf(std::string_view text, const std::string& file_name, const UrdfEnds& ends) {
  Result<UrdfTree> read = readUrdfTree(text, file_name);
  if (!read) return read.problems();
  const UrdfTree& tree = read.value();
  LinkFamily family(tree, file_name);
  if (!family.problems().empty()) return family.problems();
  const std::size_t base = family.base(ends.base);
  const std::size_t tip = base == kNone ? kNone : family.tip(ends.tip, base);
  if (!family.problems().empty()) return family.problems();
  Model model;
  model.notes = tree.notes;
  Walk(tree, family, model).go(base, family.path(base, tip));
  if (family.problems().empty() && model.joints.empty())
    family.say(tree.links[tip].line, "tip",
               phrase(TRANSLATE_NOOP("problem", "No joint between link %1 and link %2 moves."),
                      {json::shown(tree.links[base].name), json::shown(tree.links[tip].name)}));
  if (!family.problems().empty()) return family.problems();
  const Problems notes = family.takeNotes();
  model.notes.insert(model.notes.begin(), notes.begin(), notes.end());
  model.name = tree.name;
  model.title = tree.name;
  model.provenance =
      "URDF of " + tree.name + ", from link " + tree.links[base].name + " to link " + tree.links[tip].name + ".";
  model.form = ArmForm::Urdf;
  setTable(model);
  return model;
}

}  // namespace underact::arm
