#pragma once
#include "app/gui/feature/panel.h"

class QCheckBox;
class QComboBox;

namespace underact::gui {

class ColumnButton;
class LivePlot;
class Player;

/// The live plots, and the axis of force against displacement.
class PlotsPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    Actions& actions;
    Player& player;
    const Settings& settings;
  };
  PlotsPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;
  void add(const servo::TickRecord& record) override;
  void setTheme(const Theme& theme) override;
  void remember(Settings& settings) override;
  LivePlot& plot() { return *plot_; }

 private:
  Player& player_;
  LivePlot* plot_;
  QComboBox* axis_;
  QCheckBox *energy_, *hold_;
  ColumnButton* columns_;
  int frame_ = 0;
};

}  // namespace underact::gui
