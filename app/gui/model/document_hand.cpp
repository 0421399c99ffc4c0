#include <utility>

#include "app/gui/kit/edit.h"
#include "app/gui/model/document.h"
#include "core/scene/edit.h"
#include "core/scene/mirror.h"

namespace underact::gui {

// Selects the hand that the document's scene is for.

Problems Document::setLeftHanded(bool on) {
  const bool was_mirrored = is_mirrored_;
  Problems problems = takeHand(on);
  if (problems.empty() && is_mirrored_ != was_mirrored) {
    const auto take = [this](bool left) { static_cast<void>(takeHand(left)); };  // that scene was in effect before
    undo_.push(new Edit<bool>(!on, on, take, on ? tr("left-handed") : tr("right-handed")));
  }
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
  static_cast<void>(followHand());  // it was in effect before, or compiles like its mirror image
}

/// Loads it like another scene: the memory of control laws, robots and searches does not apply to the mirror image.
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
  return is_mirrored_ ? scene::mirrored(std::move(constraint), scene::mirrorPlaneOf(scene())) : constraint;
}

/// The hand is not an edit: it is not saved in files.
bool Document::modified() const {
  return !undo_.isClean() && (path_.isEmpty() || !scene::isSame(original_, scene()));
}

}  // namespace underact::gui
