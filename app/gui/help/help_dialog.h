#pragma once
#include <QDialog>

namespace underact::gui {

class Actions;

/// What the mouse and the keys do. The keys are read from the actions, so the page is never out of date.
class HelpDialog : public QDialog {
  Q_OBJECT
 public:
  HelpDialog(const Actions& actions, QWidget* parent);
};

/// Version, licence, and what has not been tested.
class AboutDialog : public QDialog {
  Q_OBJECT
 public:
  explicit AboutDialog(QWidget* parent);
};

/// "help.keys", "help.about"
void addHelpActions(Actions& actions, QWidget* window);

}  // namespace underact::gui
