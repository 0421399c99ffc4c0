#include <utility>

#include "app/gui/model/document.h"
#include "core/scene/edit.h"
#include "core/scene/mirror.h"

namespace underact::gui {

// Which hand the document's scene is for.

/// One step back or forth between the hands.
class HandEdit : public QUndoCommand {
 public:
  HandEdit(Document& document, bool left)
      : QUndoCommand(left ? Document::tr("left-handed") : Document::tr("right-handed")),
        document_(document),
        left_(left) {}
  void undo() override { static_cast<void>(document_.takeHand(!left_)); }  // that scene was in effect before
  void redo() override { static_cast<void>(document_.takeHand(left_)); }   // the first time it is so already

 private:
  Document& document_;
  bool left_;
};

Problems Document::setLeftHanded(bool on) {
  const bool was_mirrored = is_mirrored_;
  Problems problems = takeHand(on);
  if (problems.empty() && is_mirrored_ != was_mirrored) undo_.push(new HandEdit(*this, on));
  return problems;
}

Problems Document::takeHand(bool left) {
  if (left == left_handed_) return {};
  left_handed_ = left;
  Problems problems = followHand();
  if (!problems.empty()) left_handed_ = !left;
  emit leftHandedChanged(left_handed_);
  return problems;
}

void Document::keepAsWritten(bool on) {
  keeps_as_written_ = on;
  static_cast<void>(followHand());  // it was in effect before, or compiles as its mirror image did
}

/// As another scene: what a law, a robot or a search remembers of this one says nothing of the other.
Problems Document::followHand() {
  if (!is_open_ || opensMirrored() == is_mirrored_) return {};
  const scene::Description turned = scene::mirrored(scene());
  Problems problems = host_.load(turned);
  if (!problems.empty()) return problems;
  kept_.reset();
  original_ = scene::mirrored(std::move(original_));
  is_mirrored_ = !is_mirrored_;
  emit edited();
  return {};
}

scene::Description Document::throughMirror(scene::Description scene) const {
  return is_mirrored_ ? scene::mirrored(std::move(scene)) : scene;
}

scene::Constraint Document::throughMirror(scene::Constraint constraint) const {
  return is_mirrored_ ? scene::mirrored(std::move(constraint)) : constraint;
}

/// The hand is no edit: a file that is written has none.
bool Document::modified() const {
  return !undo_.isClean() && (path_.isEmpty() || !scene::isSame(original_, scene()));
}

}  // namespace underact::gui
