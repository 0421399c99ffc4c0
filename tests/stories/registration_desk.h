#pragma once
#include <QAbstractButton>
#include <QLabel>
#include <QTableWidget>
#include <QTemporaryDir>
#include <functional>

#include "app/gui/registration/registration_tool.h"
#include "app/gui/registration/registration_wizard.h"
#include "tests/stories/story.h"

namespace underact::gui::test {

// What stories about where an arm stands share.

/// An empty folder of registrations, and the user's own again at the end.
class RegistrationFolder {
 public:
  RegistrationFolder();
  ~RegistrationFolder();
  std::string path() const { return folder_.path().toStdString(); }

 private:
  QTemporaryDir folder_;
};

/// How an arm stands that is turned by a quarter and a bit to the left, its W above the middle of the sheet.
Pose turnedArm();

/// The wizard in the window of a story.
class RegistrationDesk {
 public:
  /// The window with the sphere and a simulated arm; the wizard is open.
  explicit RegistrationDesk(const Beginning& beginning = {});

  RegistrationTool& tool() { return *story.window().findChild<RegistrationTool*>(); }
  QWizard* dialog() { return story.window().findChild<RegistrationWizard*>(); }
  template <class Widget = QAbstractButton>
  Widget* in(const QString& name) {
    return qobject_cast<Widget*>(widget(name));
  }
  QString text(const QString& label) { return in<QLabel>(label)->text(); }
  void press(const QString& name);
  /// The hand brings the tip there, to 0.2 mm: past the arm's friction.
  void moveTip(const Vec3& p_WT);
  /// There, and the stylus's button; half a second later it is touched.
  void touch(const Vec3& p_WT);
  /// Marks in this order, from 0, by the arm that stands so.
  void touchAll(const std::vector<std::size_t>& order, const Pose& X_DW = turnedArm());
  /// The whole of it, up to the result.
  void toResult(const std::vector<std::size_t>& order);
  void keepPicture(const QString& name);

  RegistrationFolder folder;
  Story story;

 private:
  QWidget* widget(const QString& name);
};

}  // namespace underact::gui::test
