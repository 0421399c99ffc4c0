#pragma once
#include <memory>

#include "app/gui/feature/panel.h"
#include "app/gui/model/plot_columns.h"

class QComboBox;
class QLabel;
class QStackedWidget;

namespace underact::gui {

class ColumnButton;
class LatenessChart;
class SessionPlot;

/// Plots of the whole session that is replayed, with a cursor at the current position.
class SessionPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Actions& actions;
    SceneView& view;
    Player& player;
  };
  SessionPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;
  void poll(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;

 private:
  void show();
  void readColumns();

  Parts parts_;
  QComboBox* kind_;
  ColumnButton* columns_;
  std::unique_ptr<Background<Result<std::shared_ptr<const ColumnRows>>>> load_;  // of the columns
  QStackedWidget* pages_;
  QLabel* nothing_;
  SessionPlot* plot_;
  LatenessChart* lateness_;
  int frame_ = 0;
};

}  // namespace underact::gui
