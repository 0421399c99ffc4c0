#pragma once
#include <vector>

#include "app/gui/feature/panel.h"
#include "app/gui/model/scene_library.h"

class QIcon;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace underact::gui {

class PageView;

/// The scenes to choose from: those that come with the program, in teaching order, and recently opened files. Below the
/// list: what to feel, what to try, and the equation.
class ScenesPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    RecentFiles& recent;
    Actions& actions;
  };
  ScenesPanel(const Parts& parts, QWidget* parent);
  void setTheme(const Theme& theme) override;
  /// Wide enough for the longest name.
  QSize sizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void rebuild();
  void filter(const QString& text);
  void addHeading(const QString& text);
  void addScene(const SceneEntry& entry);
  QIcon iconOf(const QListWidgetItem& item) const;
  QListWidgetItem* firstHit() const;
  void openItem(QListWidgetItem* item);
  void markOpen();
  void keepInSight();
  void describe();

  Parts parts_;
  Theme theme_;
  std::vector<SceneEntry> shipped_;
  QLineEdit* filter_;
  QListWidget* list_;
  PageView* about_;
  bool follows_ = true;  // keep the selected scene in sight until the user scrolls
};

}  // namespace underact::gui
