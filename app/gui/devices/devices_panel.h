#pragma once
#include <QTimer>

#include "app/gui/feature/panel.h"
#include "app/gui/model/arm_search.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace underact::gui {

/// The arms that are plugged in, what keeps one from being used, and which one is in use.
class DevicesPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    ServoFacts servo;
    Actions& actions;
    ArmChoice& arms;
    Remark& where_it_stands;
  };
  DevicesPanel(const Parts& parts, QWidget* parent);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addActions();
  QWidget* buildChosen();
  QWidget* buildOther();
  QWidget* buildOpening();
  QWidget* buildRegistration();
  const ArmEntry* current() const;
  bool use(const QString& name);
  bool fix();
  bool report();
  void rebuild();
  void describe();
  void presentArm();
  void tell(const QString& sentence);

  Parts parts_;
  ArmSearch* search_;
  QTimer poll_timer_;
  QLabel *in_use_ = nullptr, *about_ = nullptr, *told_ = nullptr, *opening_ = nullptr, *registered_ = nullptr;
  QListWidget* list_ = nullptr;
  QPushButton *use_ = nullptr, *fix_ = nullptr, *report_ = nullptr, *cancel_ = nullptr;
  QLineEdit* other_ = nullptr;
  QProgressBar* bar_ = nullptr;
};

}  // namespace underact::gui
