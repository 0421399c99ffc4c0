#include "core/arm/urdf.h"

#include <algorithm>
#include <unordered_map>

#include "core/arm/joint_reader.h"
#include "core/arm/solid_place.h"
#include "core/arm/urdf_tree.h"
#include "core/base/translate.h"
#include "core/json/text.h"

namespace underact::arm {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr std::size_t kMostListed = 8;
constexpr std::size_t kMostProblems = 100;
constexpr std::size_t kLargestUrdf = std::size_t{4} << 20;  // a humanoid with its sensors has some 100 kB

/// One step from link to link: through a joint, to its child or back to its parent.
struct UrdfStep {
  std::size_t joint = 0;
  bool down = true;
};

/// The links of a tree by name, and the joint above each.
class LinkFamily {
 public:
  LinkFamily(const UrdfTree& tree, const std::string& file)
      : tree_(tree), file_(file), above_(tree.links.size(), kNone) {
    for (std::size_t i = 0; i < tree.links.size(); ++i) index_.emplace(tree.links[i].name, i);
    std::vector<bool> has_child(tree.links.size(), false);
    for (std::size_t i = 0; i < tree.joints.size(); ++i) {
      const UrdfJoint& joint = tree.joints[i];
      const std::size_t parent = find(joint.parent, joint.line, "parent"),
                        child = find(joint.child, joint.line, "child");
      if (parent == kNone || child == kNone) continue;
      has_child[parent] = true;
      if (above_[child] != kNone) {
        say(joint.line, "child",
            said(TRANSLATE_NOOP("problem", "The link %1 has two parents."), {json::shown(joint.child)}));
      } else {
        above_[child] = i;
      }
    }
    for (std::size_t i = 0; i < tree.links.size(); ++i) {
      if (above_[i] == kNone) roots_.push_back(i);
      if (!has_child[i]) leaves_.push_back(i);
    }
  }

  /// The link of a name given by whoever asks, or the only candidate.
  std::size_t end(const std::string& name, const char* which) {
    if (!name.empty()) return find(name, 0, which);
    const std::vector<std::size_t>& all = which == std::string_view("base") ? roots_ : leaves_;
    if (all.size() == 1) return all.front();
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(all.size(), kMostListed); ++i) names.push_back(tree_.links[all[i]].name);
    if (all.empty()) {
      say(0, which, said(TRANSLATE_NOOP("problem", "The robot has no link that could be its %1."), {which}));
    } else {
      say(tree_.links[all[1]].line, which,
          said(TRANSLATE_NOOP("problem", "Say which link is the %1 (arm convert --%1 LINK): %2, for example."),
               {which, json::listed(names)}));
    }
    return kNone;
  }

  /// From link to link by way of their nearest common parent; empty and a problem where there is none.
  std::vector<UrdfStep> way(std::size_t base, std::size_t tip) {
    const std::vector<std::size_t> from_base = upwards(base), from_tip = upwards(tip);  // links, each with its parents
    std::vector<std::size_t> up_from_tip(tree_.links.size(), kNone);  // the number of joints from the tip up to a link
    for (std::size_t i = from_tip.size(); i-- > 0;) up_from_tip[from_tip[i]] = i;
    for (std::size_t i = 0; i < from_base.size(); ++i) {
      if (up_from_tip[from_base[i]] == kNone) continue;
      std::vector<UrdfStep> steps;
      for (std::size_t j = 0; j < i; ++j) steps.push_back({above_[from_base[j]], false});
      for (std::size_t j = up_from_tip[from_base[i]]; j-- > 0;) steps.push_back({above_[from_tip[j]], true});
      return steps;
    }
    say(tree_.links[tip].line, "tip",
        said(TRANSLATE_NOOP("problem", "No joints lead from link %1 to link %2."),
             {json::shown(tree_.links[base].name), json::shown(tree_.links[tip].name)}));
    return {};
  }

  std::size_t indexOf(const std::string& name) const { return index_.at(name); }
  void say(int line, const std::string& key, Sentence sentence) {
    if (problems_.size() < kMostProblems) problems_.push_back({std::move(sentence), {file_, line, 0, key}});
  }
  const Problems& problems() const { return problems_; }

 private:
  std::size_t find(const std::string& name, int line, const char* key) {
    const auto found = index_.find(name);
    if (found != index_.end()) return found->second;
    if (problems_.size() >= kMostListed) return kNone;
    std::vector<std::string> known;
    for (const UrdfLink& link : tree_.links) known.push_back(link.name);
    const std::string nearest = json::nearestWord(name, known);
    say(line, key,
        nearest.empty() ? said(TRANSLATE_NOOP("problem", "There is no link %1."), {json::shown(name)})
                        : said(TRANSLATE_NOOP("problem", "There is no link %1. Did you mean \"%2\"?"),
                               {json::shown(name), nearest}));
    return kNone;
  }

  std::vector<std::size_t> upwards(std::size_t link) const {
    std::vector<std::size_t> links{link};
    while (above_[link] != kNone && links.size() <= tree_.links.size()) {  // a ring of links ends, too
      link = index_.at(tree_.joints[above_[link]].parent);
      links.push_back(link);
    }
    return links;
  }

  const UrdfTree& tree_;
  std::string file_;
  std::vector<std::size_t> above_;  // of each link
  std::vector<std::size_t> roots_, leaves_;
  std::unordered_map<std::string, std::size_t> index_;
  Problems problems_;
};

/// Another mass on the same link.
void addTo(LinkMass& all, const LinkMass& one) {
  const double total_kg = all.mass_kg + one.mass_kg;
  if (!(total_kg > 0.0)) return;
  const Vec3 p_WC = (all.mass_kg * all.p_WC + one.mass_kg * one.p_WC) / total_kg;
  const auto about = [&](const LinkMass& mass) {  // Steiner's theorem
    const Vec3 way = mass.p_WC - p_WC;
    return Mat3(mass.inertia_W_kg_m2 + mass.mass_kg * (way.squaredNorm() * Mat3::Identity() - way * way.transpose()));
  };
  all = {total_kg, p_WC, Mat3(about(all) + about(one))};
}

/// Walks from base to tip: places each joint and mass in W, with all joints at 0.
class Walk {
 public:
  Walk(const UrdfTree& tree, LinkFamily& family, Model& model) : tree_(tree), family_(family), model_(model) {}

  void go(std::size_t base, const std::vector<UrdfStep>& steps) {
    show(tree_.links[base]);
    for (const UrdfStep& step : steps) pass(step);
    model_.chain.X_WT_home = X_WLink_;
    // With a form among them that no solid has, the rest would be a part of an arm.
    if (any_other_ || model_.solids.size() > kMostSolids) model_.solids.clear();
    if (!any_mass_) model_.masses.clear();
  }

 private:
  void pass(const UrdfStep& step) {
    const UrdfJoint& joint = tree_.joints[step.joint];
    if (step.down) X_WLink_ = X_WLink_ * joint.X_ParentJoint;
    add(joint, step.down ? 1.0 : -1.0);
    if (!step.down) X_WLink_ = X_WLink_ * joint.X_ParentJoint.inverse(Eigen::Isometry);
    carry(tree_.links[family_.indexOf(step.down ? joint.child : joint.parent)]);
  }

  void add(const UrdfJoint& joint, double sense) {
    if (joint.motion == UrdfMotion::Fixed) return;
    if (joint.motion == UrdfMotion::Other)
      return family_.say(
          joint.line, "type",
          said(TRANSLATE_NOOP("problem",
                              "The joint %1 is %2; a joint of an arm turns about an axis or slides along it."),
               {json::shown(joint.name), json::shown(joint.type)}));
    if (joint.follows)
      return family_.say(
          joint.line, "mimic",
          said(TRANSLATE_NOOP("problem", "The joint %1 follows another one; each joint of an arm moves by itself."),
               {json::shown(joint.name)}));
    if (!(joint.min < joint.max))  // of a joint beside the way, such as a wheel, nobody asks
      family_.say(joint.limit_line, "lower",
                  said(TRANSLATE_NOOP("problem", "The joint's lower limit must be below its upper limit.")));
    const bool turns = joint.motion == UrdfMotion::Turns;
    model_.chain.joints.push_back({turns ? chain::JointType::Revolute : chain::JointType::Prismatic,
                                   sense * (X_WLink_.linear() * joint.axis).normalized(), X_WLink_.translation(),
                                   joint.min, joint.max});
    model_.joints.push_back({joint.name, true, true, {}});
    model_.masses.emplace_back();
    if (model_.joints.size() == kMostJoints + 1)
      family_.say(joint.line, "joint",
                  said(TRANSLATE_NOOP("problem", "An arm has from one to eight joints; this is the ninth.")));
  }

  void show(const UrdfLink& link) {
    any_other_ |= link.has_other_form;
    for (const LinkSolid& solid : link.solids)
      model_.solids.push_back({model_.joints.size(), X_WLink_ * solid.X_WS, solid.form});
  }

  void carry(const UrdfLink& link) {
    show(link);
    if (!link.mass || model_.masses.empty()) return;
    any_mass_ = true;
    const Mat3& R = X_WLink_.linear();
    addTo(model_.masses.back(),
          {link.mass->mass_kg, X_WLink_ * link.mass->p_WC, R * link.mass->inertia_W_kg_m2 * R.transpose()});
  }

  const UrdfTree& tree_;
  LinkFamily& family_;
  Model& model_;
  Pose X_WLink_ = Pose::Identity();
  bool any_mass_ = false, any_other_ = false;
};

}  // namespace

bool isUrdfName(std::string_view path) {
  return path.ends_with(".urdf") || path.ends_with(".xml");
}

Result<Model> readUrdf(std::string_view text, const std::string& file_name, const UrdfEnds& ends) {
  const Result<UrdfTree> read = readUrdfTree(text, file_name);
  if (!read) return read.problems();
  const UrdfTree& tree = read.value();
  LinkFamily family(tree, file_name);
  if (!family.problems().empty()) return family.problems();
  const std::size_t base = family.end(ends.base, "base"), tip = family.end(ends.tip, "tip");
  if (!family.problems().empty()) return family.problems();
  Model model;
  Walk(tree, family, model).go(base, family.way(base, tip));
  if (family.problems().empty() && model.joints.empty())
    family.say(tree.links[tip].line, "tip",
               said(TRANSLATE_NOOP("problem", "No joint between link %1 and link %2 moves."),
                    {json::shown(tree.links[base].name), json::shown(tree.links[tip].name)}));
  if (!family.problems().empty()) return family.problems();
  model.name = tree.name;
  model.title = tree.name;
  model.provenance =
      "URDF of " + tree.name + ", from link " + tree.links[base].name + " to link " + tree.links[tip].name + ".";
  model.form = ArmForm::Urdf;
  setTable(model);
  return model;
}

Result<Model> readUrdfFile(const std::string& path, const UrdfEnds& ends) {
  const Result<std::string> text = json::readTextFile(path, said(TRANSLATE_NOOP("problem", "an arm")), kLargestUrdf);
  if (!text) return text.problems();
  return withFolderOf(path, readUrdf(text.value(), path, ends));
}

}  // namespace underact::arm
