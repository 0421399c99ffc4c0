#pragma once
#include <QObject>
#include <QTimer>
#include <QUndoStack>
#include <optional>

#include "core/scene/settings.h"
#include "core/servo/host.h"

namespace underact::gui {

/// The scene in the window: its file, the scene as saved there and as edited, and the undo stack. The servo's host owns
/// the scene in effect; this is the editor's side. Files are for the right hand. For the left hand the scene in effect
/// is their mirror image; "in effect" below refers to that.
class Document : public QObject {
  Q_OBJECT
 public:
  explicit Document(servo::Host& host, QObject* parent = nullptr);

  /// Opens a scene as in its file, with its meshes loaded, replacing the current one. Its file: where it was read from;
  /// none: it is new and was never saved. tuned: as it is to be in effect, as one step that can be undone. Problems:
  /// what is wrong with it; the old scene then stays in effect.
  Problems open(scene::Description opened, const std::optional<scene::Description>& tuned = {});
  /// Saves the current scene, for the right hand; that becomes its file, and its values become the scene's own. Mesh
  /// paths are relative to it.
  Problems saveAs(const QString& path);

  /// Replaces scene() by after, an edited copy. what: "stiffness x", for the undo menu. gesture: successive edits with
  /// the same number (one drag) become one step. Problems: the old scene stays.
  Problems edit(const scene::Description& after, const QString& what, int gesture);
  /// Edits for a program, which may send hundreds in a second: panels are told of the newest only, some 25 times a
  /// second. over_ticks: as for servo::Host::edit().
  Problems steer(const scene::Description& after, const QString& what, int gesture, std::int64_t over_ticks);
  /// A number not used by any edit yet.
  int newGesture() { return ++gestures_; }

  /// Puts a scene into effect temporarily, as a measurement does: scene() and the undo stack are unchanged. An edit, an
  /// undo, another scene or putBack() ends it. Problems: the scene in effect stays.
  Problems tryOut(const scene::Description& tried);
  /// Puts scene() into effect again.
  void putBack();
  bool isTryingOut() const { return kept_.has_value(); }

  /// Shows a recording's scene instead of the user's own, which is kept until putBackOwn(). It has no file; edits of
  /// the previous recorded scene are lost. Problems: the scene in effect stays.
  Problems showRecorded(const scene::Description& scene);
  /// Restores the scene from before showRecorded(), with its file and its edits (as one undo step).
  void putBackOwn();
  bool showsRecorded() const { return own_.has_value(); }

  /// From now on scenes are for the left hand: the one in effect is mirrored as a step that can be undone, others when
  /// they are opened; a recording's scene, and one kept as written, is not mirrored. Problems: scene and hand stay.
  Problems setLeftHanded(bool on);
  bool isLeftHanded() const { return left_handed_; }
  /// Keeps scenes as in their files for a while, whichever the hand: lessons refer to left and right.
  void keepAsWritten(bool on);
  bool keepsAsWritten() const { return keeps_as_written_; }
  /// Whether the scene in effect is the mirror image of its file's.
  bool isMirrored() const { return is_mirrored_; }
  /// Whether the next scene opened will be mirrored.
  bool opensMirrored() const { return left_handed_ && !keeps_as_written_ && !own_; }
  /// The scene as it would be saved.
  scene::Description asWritten() const { return throughMirror(scene()); }
  /// The scene as in its file.
  scene::Description originalAsWritten() const { return throughMirror(original_); }
  /// Converts between the scene as in a file and as in effect; the same in both directions.
  scene::Description throughMirror(scene::Description scene) const;
  scene::Constraint throughMirror(scene::Constraint constraint) const;

  const scene::Description& scene() const { return kept_ ? *kept_ : host_.scene(); }
  // As in the file, found by the name of the constraint now at index, since others may have been added or removed.
  /// The control at index as in the file; for a constraint that the file does not have, the scene's.
  const scene::Control& own(std::size_t index) const;
  /// The constraint at index as in the file; an empty point if the file does not have it.
  const scene::Constraint& written(std::size_t index) const;
  /// A setting of it, by its path relative to the constraint, "/influence/t"; none: it has no such setting.
  scene::SettingValue own(std::size_t index, const std::string& path) const;
  /// The current value.
  scene::SettingValue value(std::size_t index, const std::string& path) const;
  bool isOpen() const { return is_open_ || own_; }
  bool modified() const;
  QString path() const { return path_; }  // empty: no file
  QUndoStack& undoStack() { return undo_; }

 signals:
  void opened();
  void edited();
  void editedHere();  // besides: by the person, not by a program
  void modifiedChanged(bool modified);
  void leftHandedChanged(bool on);

 private:
  Problems change(const scene::Description& after, const QString& what, int gesture, std::int64_t over_ticks);
  /// Both as written, since the hand may be another one when they take effect again.
  void pushEdit(scene::Description before, scene::Description after, const QString& what, int gesture);
  void put(const scene::Description& written);  // a scene that was in effect before
  Problems takeHand(bool left);
  Problems followHand();

  struct Own {
    scene::Description scene, original;  // as written
    QString path;
  };

  servo::Host& host_;
  scene::Description original_;             // as in its file, mirrored if the scene in effect is
  std::optional<scene::Description> kept_;  // while another scene is tried out
  std::optional<Own> own_;                  // while a recording's is shown
  QString path_;
  bool is_open_ = false;
  bool left_handed_ = false, keeps_as_written_ = false, is_mirrored_ = false;
  QUndoStack undo_;
  QTimer tells_;  // of what a program has done
  int gestures_ = 0;
};

}  // namespace underact::gui
