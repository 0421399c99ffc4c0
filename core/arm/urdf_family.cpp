#include "core/arm/urdf_family.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "core/arm/preset.h"
#include "core/base/translate.h"
#include "core/json/text.h"

namespace underact::arm {
namespace {

constexpr std::size_t kMaxListed = 8;
constexpr std::size_t kMaxFamilyProblems = 100;
constexpr std::size_t kJointsBeforeGripper = 3, kJointsOfWrist = 3;

/// Whether a link is called what the tool of an arm is: tool0 as in ROS's REP 199, or as makers of arms do.
bool isToolName(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter; });
  constexpr std::array<const char*, 6> kNames{"tool0", "tcp", "end_effector", "endeffector", "ee_link", "eef"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](const char* one) { return name.find(one) != std::string::npos; });
}

}  // namespace

LinkFamily::LinkFamily(const UrdfTree& tree, const std::string& file)
    : tree_(tree), file_(file), above_(tree.links.size(), kNone), below_(tree.links.size()) {
  for (std::size_t i = 0; i < tree.links.size(); ++i) index_.emplace(tree.links[i].name, i);
  for (std::size_t i = 0; i < tree.joints.size(); ++i) {
    const UrdfJoint& joint = tree.joints[i];
    const std::size_t parent = find(joint.parent, joint.line, "parent"), child = find(joint.child, joint.line, "child");
    if (parent == kNone || child == kNone) continue;
    if (above_[child] != kNone) {
      say(joint.line, "child",
          phrase(TRANSLATE_NOOP("problem", "The link %1 has two parents."), {json::shown(joint.child)}));
    } else {
      above_[child] = i;
      below_[parent].push_back(i);
    }
  }
}

void LinkFamily::refuseToChoose(const std::vector<std::size_t>& all, const char* which) {
  if (all.empty())
    return say(0, which, phrase(TRANSLATE_NOOP("problem", "The robot has no link that could be its %1."), {which}));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(all.size(), kMaxListed); ++i) names.push_back(tree_.links[all[i]].name);
  say(tree_.links[all[1]].line, which,
      phrase(TRANSLATE_NOOP("problem", "Say which link is the %1 (arm convert --%1 LINK): %2, for example."),
             {which, json::listed(names)}));
}

std::size_t LinkFamily::base(const std::string& name) {
  if (!name.empty()) return find(name, 0, "base");
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < tree_.links.size(); ++i) {
    if (above_[i] == kNone) roots.push_back(i);
  }
  std::vector<std::size_t> with_joints;
  std::copy_if(roots.begin(), roots.end(), std::back_inserter(with_joints),
               [&](std::size_t root) { return !below_[root].empty(); });
  if (with_joints.size() == 1) roots = with_joints;  // a link that hangs on nothing, and nothing on it, is no base
  if (roots.size() != 1) {
    refuseToChoose(roots, "base");
    return kNone;
  }
  std::size_t base = roots.front();
  for (;;) {
    const std::vector<std::size_t> joints = leaving(bodyOf(base, false));
    if (joints.size() != 1 || tree_.joints[joints[0]].motion != UrdfMotion::Other) return base;
    const UrdfJoint& joint = tree_.joints[joints[0]];
    base = indexOf(joint.child);
    note(joint.line, "type",
         phrase(TRANSLATE_NOOP("problem", "The joint %1 is %2, so link %3 is taken as the base."),
                {json::shown(joint.name), json::shown(joint.type), json::shown(joint.child)}));
  }
}

std::size_t LinkFamily::tip(const std::string& name, std::size_t base) {
  if (!name.empty()) return find(name, 0, "tip");
  std::vector<std::size_t> leaves;
  for (std::size_t i = 0; i < tree_.links.size(); ++i) {
    if (below_[i].empty() && above_[i] != kNone) leaves.push_back(i);
  }
  if (leaves.size() == 1) return leaves.front();
  const Reach reach = reachOf(base, 0);
  if (reach.joints == 0) {  // it is said of the way that nothing moves; or the arm goes upwards from here
    if (above_[base] == kNone) return reach.tip;
    refuseToChoose(leaves, "tip");
    return kNone;
  }
  std::vector<std::string> others;
  for (const std::size_t leaf : leaves) {
    if (leaf != reach.tip && others.size() < kMaxListed) others.push_back(tree_.links[leaf].name);
  }
  note(tree_.links[reach.tip].line, "tip",
       phrase(TRANSLATE_NOOP("problem", "Link %1 is taken as the tip. --tip LINK takes another one: %2, for example."),
              {json::shown(tree_.links[reach.tip].name), json::listed(others)}));
  return reach.tip;
}

std::vector<std::size_t> LinkFamily::leaving(const std::vector<BodyLink>& body) const {
  std::vector<std::size_t> joints;
  for (const BodyLink& one : body) {
    std::copy_if(below_[one.link].begin(), below_[one.link].end(), std::back_inserter(joints),
                 [&](std::size_t joint) { return tree_.joints[joint].motion != UrdfMotion::Fixed; });
  }
  return joints;
}

LinkFamily::Reach LinkFamily::reachOf(std::size_t link, std::size_t passed) const {
  const std::vector<BodyLink> body = bodyOf(link, false);
  const std::vector<std::size_t> joints = leaving(body);
  // One joint too many, so that a longer arm is refused and not cut off.
  if (joints.empty() || passed > kMaxJoints) return {lastOf(body), passed};
  Reach best;
  bool is_only = true;  // no other way is as long
  for (const std::size_t i : joints) {
    const UrdfJoint& joint = tree_.joints[i];
    if (joints.size() > 1 && (joint.follows || joint.motion == UrdfMotion::Other)) continue;
    const Reach reach = reachOf(indexOf(joint.child), passed + 1);
    const bool fits = reach.joints <= kMaxJoints, best_fits = best.joints <= kMaxJoints;
    const bool is_better =
        best.tip == kNone || (fits && !best_fits) || (fits == best_fits && reach.joints > best.joints);
    is_only = is_better || (is_only && reach.joints < best.joints);
    if (is_better) best = reach;
  }
  const bool goes_on = is_only && best.joints >= passed + kJointsOfWrist && best.joints <= kMaxJoints;
  const bool at_gripper = joints.size() > 1 && passed >= kJointsBeforeGripper && !goes_on;
  return best.tip == kNone || at_gripper ? Reach{lastOf(body), passed} : best;
}

std::size_t LinkFamily::lastOf(const std::vector<BodyLink>& body) const {
  std::size_t best = body.front().link;
  std::tuple<bool, bool, std::size_t> max{false, false, 0};
  for (const auto& [link, X_FirstLink, depth] : body) {
    const bool bears = std::any_of(below_[link].begin(), below_[link].end(),
                                   [&](std::size_t joint) { return tree_.joints[joint].motion != UrdfMotion::Fixed; });
    if (!bears && !below_[link].empty()) continue;
    const std::tuple<bool, bool, std::size_t> rank{isToolName(tree_.links[link].name), bears, depth};
    if (rank > max) best = link, max = rank;
  }
  return best;
}

std::vector<BodyLink> LinkFamily::bodyOf(std::size_t link, bool above) const {
  std::vector<BodyLink> body{{link, Pose::Identity()}};
  std::vector<std::size_t> through{kNone};  // the joint by which each was reached
  for (std::size_t i = 0; i < body.size() && body.size() <= tree_.links.size(); ++i) {
    const auto add = [&](std::size_t joint, const std::string& name, const Pose& X) {
      if (joint == through[i] || tree_.joints[joint].motion != UrdfMotion::Fixed) return;
      const Pose X_FirstLink = body[i].X_FirstLink * X;
      body.push_back({indexOf(name), X_FirstLink, body[i].depth + 1});
      through.push_back(joint);
    };
    const std::size_t at = body[i].link;
    for (const std::size_t joint : below_[at]) add(joint, tree_.joints[joint].child, tree_.joints[joint].X_ParentJoint);
    if (above && above_[at] != kNone) {
      const UrdfJoint& joint = tree_.joints[above_[at]];
      add(above_[at], joint.parent, joint.X_ParentJoint.inverse(Eigen::Isometry));
    }
  }
  return body;
}

std::vector<UrdfStep> LinkFamily::path(std::size_t base, std::size_t tip) {
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
      phrase(TRANSLATE_NOOP("problem", "No joints lead from link %1 to link %2."),
             {json::shown(tree_.links[base].name), json::shown(tree_.links[tip].name)}));
  return {};
}

void LinkFamily::say(int line, const std::string& key, Sentence sentence) {
  if (problems_.size() < kMaxFamilyProblems) problems_.push_back({std::move(sentence), {file_, line, 0, key}});
}

void LinkFamily::note(int line, const std::string& key, Sentence sentence) {
  notes_.push_back({std::move(sentence), {file_, line, 0, key}});
}

std::size_t LinkFamily::find(const std::string& name, int line, const char* key) {
  const auto found = index_.find(name);
  if (found != index_.end()) return found->second;
  if (problems_.size() >= kMaxListed) return kNone;
  std::vector<std::string> known;
  for (const UrdfLink& link : tree_.links) known.push_back(link.name);
  const std::string nearest = json::nearestWord(name, known);
  say(line, key,
      nearest.empty() ? phrase(TRANSLATE_NOOP("problem", "There is no link %1."), {json::shown(name)})
                      : phrase(TRANSLATE_NOOP("problem", "There is no link %1. Did you mean \"%2\"?"),
                               {json::shown(name), nearest}));
  return kNone;
}

std::vector<std::size_t> LinkFamily::upwards(std::size_t link) const {
  std::vector<std::size_t> links{link};
  while (above_[link] != kNone && links.size() <= tree_.links.size()) {  // a ring of links ends, too
    link = index_.at(tree_.joints[above_[link]].parent);
    links.push_back(link);
  }
  return links;
}

}  // namespace underact::arm
