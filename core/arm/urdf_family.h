#pragma once
#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/arm/urdf_tree.h"

namespace underact::arm {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// One step from link to link: through a joint, to its child or back to its parent.
struct UrdfStep {
  std::size_t joint = 0;
  bool down = true;
};

/// A link of a body, and its frame in that of the link from which the body was looked at.
struct BodyLink {
  std::size_t link = 0;
  Pose X_FirstLink = Pose::Identity();
  std::size_t depth = 0;  // the fixed joints between them
};

/// Inside the room: the links of a tree by name, and the joints above and below each. Collects problems and notes.
class LinkFamily {
 public:
  /// tree: longer-lived. file: its name, for problems.
  LinkFamily(const UrdfTree& tree, const std::string& file);

  /// The link of a name given by whoever asks. Without a name the root, or where that is moved as no arm is (a floating
  /// base) the link that it leads to. kNone and a problem: there is none, or there are several.
  std::size_t base(const std::string& name);
  /// Finds the tip likewise. Without a name: links that no joint moves are none. Where several joints go on from a
  /// body, the way with the most goes on. After three joints it ends there, as before the fingers of a gripper, unless
  /// one way alone has three more, as beside a rod that drives the elbow. Of several links of the last body: one with a
  /// usual name (tool0, tcp, ...), else what bears the fingers, else the furthest. A choice is noted.
  std::size_t tip(const std::string& name, std::size_t base);

  /// From link to link by way of their nearest common parent; empty and a problem where there is none.
  std::vector<UrdfStep> path(std::size_t base, std::size_t tip);
  /// A link and all that are fixed to it: those below, and if asked for those above.
  std::vector<BodyLink> bodyOf(std::size_t link, bool above) const;

  /// The number of a link that there is.
  std::size_t indexOf(const std::string& name) const { return index_.at(name); }
  /// The joints below a link, in the order of the file.
  const std::vector<std::size_t>& below(std::size_t link) const { return below_[link]; }
  /// The joint above it, or kNone.
  std::size_t above(std::size_t link) const { return above_[link]; }

  /// Adds a problem.
  void say(int line, const std::string& key, Sentence sentence);
  /// Adds a note.
  void note(int line, const std::string& key, Sentence sentence);
  /// All so far.
  const Problems& problems() const { return problems_; }
  /// All notes.
  Problems takeNotes() { return std::move(notes_); }

 private:
  struct Reach {
    std::size_t tip = kNone, joints = 0;
  };

  std::size_t find(const std::string& name, int line, const char* key);
  std::vector<std::size_t> upwards(std::size_t link) const;
  /// The joints that leave a body and are not fixed.
  std::vector<std::size_t> leaving(const std::vector<BodyLink>& body) const;
  Reach reachOf(std::size_t link, std::size_t passed) const;
  std::size_t lastOf(const std::vector<BodyLink>& body) const;
  void refuseToChoose(const std::vector<std::size_t>& all, const char* which);

  const UrdfTree& tree_;
  std::string file_;
  std::vector<std::size_t> above_;  // of each link
  std::vector<std::vector<std::size_t>> below_;
  std::unordered_map<std::string, std::size_t> index_;
  Problems problems_, notes_;
};

}  // namespace underact::arm
