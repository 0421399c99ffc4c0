#pragma once
#include <QWidget>

#include "app/gui/feature/servo_listener.h"
#include "app/gui/kit/theme.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace underact::gui {

class Actions;
class Document;
class GhostHand;

/// The strip below the view while a recorded hand is followed: play and pause, speed, current and past distance, and at
/// the end the result, which a screen reader announces once.
class GhostStrip : public QWidget, public ServoListener {
  Q_OBJECT
 public:
  GhostStrip(GhostHand& ghost, const Document& document, Actions& actions, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;

 private:
  void buildTransport(QVBoxLayout* column);
  void buildChoices(QVBoxLayout* column);
  void buildTold(QVBoxLayout* column);
  QCheckBox* box(const char* name, const QString& words, const QString& tip);
  void presentOptions();
  void presentNotes();
  void presentNumbers();
  void sayResult();

  GhostHand& ghost_;
  const Document& document_;
  Actions& actions_;
  QToolButton *play_ = nullptr, *restart_ = nullptr;
  QComboBox* speed_ = nullptr;
  QCheckBox *wait_ = nullptr, *near_ = nullptr, *loop_ = nullptr, *mirror_ = nullptr;
  QDoubleSpinBox* beyond_ = nullptr;
  QLabel *time_ = nullptr, *now_ = nullptr, *told_ = nullptr, *last_ = nullptr, *notes_ = nullptr;
  QPushButton *copy_ = nullptr, *scene_ = nullptr;
  Theme theme_ = Theme::light();
  bool shows_pause_ = false;
  int frame_ = 0;
};

}  // namespace underact::gui
