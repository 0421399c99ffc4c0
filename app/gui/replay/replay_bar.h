#pragma once
#include <QWidget>

#include "app/gui/feature/servo_listener.h"
#include "app/gui/kit/theme.h"
#include "core/servo/snapshot.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace underact::gui {

class Actions;
class ComparisonTable;
class Player;
class ScrubSlider;

/// Below the view while a session is opened or replayed: position, play and pause, speed, loop, what if.
class ReplayBar : public QWidget, public ServoListener {
  Q_OBJECT
 public:
  ReplayBar(Player& player, Actions& actions, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;
  QString busyReason() const override;

 private:
  void buildLoading(QVBoxLayout* column);
  void buildTransport(QVBoxLayout* column);
  void buildChoices(QVBoxLayout* column);
  QToolButton* button(const char* action, const QString& spoken);
  QCheckBox* box(const char* action, const QString& words);
  void show(bool loads, bool plays);
  void begin();
  void presentPlace();
  void presentSpeed();

  Player& player_;
  Actions& actions_;
  QWidget *loading_, *replay_;
  QLabel *reading_, *time_, *here_;
  QProgressBar* progress_;
  QToolButton *play_, *back_, *forward_;
  ScrubSlider* scrub_;
  QComboBox* speed_;
  ComparisonTable* comparison_;
  Theme theme_ = Theme::light();
  bool shows_pause_ = false;
  int frame_ = 0;
};

}  // namespace underact::gui
