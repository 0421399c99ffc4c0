#pragma once
#include <QObject>
#include <QUndoStack>
#include <optional>

#include "core/scene/settings.h"
#include "core/servo/host.h"

namespace underact::gui {

/// The scene in the window: the file it came from, as the file has it and as it is now, and the way back. The servo's
/// host keeps the scene in effect; this is the editor's side of it. Files are for the right hand. For the left one what
/// is in effect is their mirror image, and all that says "in effect" here is that.
class Document : public QObject {
  Q_OBJECT
 public:
  explicit Document(servo::Host& host, QObject* parent = nullptr);

  /// Opens a scene as its file has it, with its meshes loaded, in place of the one there is. Its file: where it was
  /// read from; none: it is new, and was never saved. Problems: what is wrong with it; then the old scene stays in
  /// effect.
  Problems open(scene::Description opened);
  /// Writes the scene as it is now, for the right hand; from then on that is its file, and its gains are the scene's
  /// own. Meshes are named as seen from there.
  Problems saveAs(const QString& path);

  /// Puts after, an edit of scene(), in its place. what: "stiffness x", for the undo menu. gesture: edits in a row with
  /// the same number (one drag) become one step. Problems: the old scene stays.
  Problems edit(const scene::Description& after, const QString& what, int gesture);
  /// A number that no edit has had yet.
  int newGesture() { return ++gestures_; }

  /// Puts a scene into effect for a while, as a measurement does: scene() and the undo stack stay what they are. An
  /// edit, an undo, another scene or putBack() ends it. Problems: what is in effect stays.
  Problems tryOut(const scene::Description& tried);
  /// scene() is in effect again.
  void putBack();
  bool isTryingOut() const { return kept_.has_value(); }

  /// A recording's scene, in place of the one there is, which is kept until putBackOwn(); it has no file, and what was
  /// edited since the last one is gone. Problems: what is in effect stays.
  Problems showRecorded(const scene::Description& scene);
  /// The scene from before showRecorded() is there again, with its file and its edits (as one step to undo).
  void putBackOwn();
  bool showsRecorded() const { return own_.has_value(); }

  /// From now on scenes are there for the left hand: the one in effect goes over as a step that can be undone, the
  /// others as they are opened; a recording's, and one that is kept as written, stays. Problems: the old scene stays,
  /// and so does the hand.
  Problems setLeftHanded(bool on);
  bool isLeftHanded() const { return left_handed_; }
  /// Scenes are as their files have them for a while, whichever hand: a lesson speaks of left and right.
  void keepAsWritten(bool on);
  /// The scene in effect is the mirror image of its file's.
  bool isMirrored() const { return is_mirrored_; }
  /// The next one that is opened will be.
  bool opensMirrored() const { return left_handed_ && !keeps_as_written_ && !own_; }
  /// The scene as a file would have it.
  scene::Description asWritten() const { return throughMirror(scene()); }
  /// From how a file has it to how it is in effect, or back: both are the same.
  scene::Description throughMirror(scene::Description scene) const;
  scene::Constraint throughMirror(scene::Constraint constraint) const;

  const scene::Description& scene() const { return kept_ ? *kept_ : host_.scene(); }
  // As the file has it, by the name of the constraint that is at index now: others may have been added or taken away.
  /// The control at index as the file has it; of a constraint the file does not have, the scene's.
  const scene::Control& own(std::size_t index) const;
  /// The constraint at index as the file has it; a point with nothing to it: the file does not have it.
  const scene::Constraint& written(std::size_t index) const;
  /// A setting of it, by its path from there on, "/influence/t"; none: it has none.
  scene::SettingValue own(std::size_t index, const std::string& path) const;
  /// As it holds.
  scene::SettingValue value(std::size_t index, const std::string& path) const;
  bool isOpen() const { return is_open_ || own_; }
  bool modified() const;
  QString path() const { return path_; }  // empty: it has no file
  QUndoStack& undoStack() { return undo_; }

 signals:
  void opened();
  void edited();
  void modifiedChanged(bool modified);
  void leftHandedChanged(bool on);

 private:
  /// Both as written: whichever hand it is when they are put into effect again.
  void pushEdit(scene::Description before, scene::Description after, const QString& what, int gesture);
  void put(const scene::Description& written);  // one that was in effect before
  Problems takeHand(bool left);
  Problems followHand();

  struct Own {
    scene::Description scene, original;  // as written
    QString path;
  };

  servo::Host& host_;
  scene::Description original_;             // as its file has it, through the mirror where the one in effect is
  std::optional<scene::Description> kept_;  // while another scene is tried out in its place
  std::optional<Own> own_;                  // while a recording's is shown
  QString path_;
  bool is_open_ = false;
  bool left_handed_ = false, keeps_as_written_ = false, is_mirrored_ = false;
  QUndoStack undo_;
  int gestures_ = 0;
};

}  // namespace underact::gui
