#pragma once
#include <QDialog>

#include "app/gui/visitor/visitor_settings.h"

class QLabel;
class QListWidget;
class QSpinBox;

namespace underact::gui {

/// What the demonstrator can change in visitor mode: scenes, their duration and the force; and the way out.
class DemonstratorPanel : public QDialog {
  Q_OBJECT
 public:
  DemonstratorPanel(const VisitorSettings& visitor_settings, QWidget* window);
  VisitorSettings visitorSettings() const;
  /// Tells the demonstrator, for example, which files cannot be shown.
  void tell(const QString& sentence);

 signals:
  void changed();
  void stopAsked();
  void leaveAsked();

 private:
  void addScene(const QString& path, bool is_chosen);

  QListWidget* scenes_;
  QSpinBox *dwell_, *force_;
  QLabel* told_;
};

}  // namespace underact::gui
