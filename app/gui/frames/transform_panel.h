#pragma once
#include <vector>

#include "app/gui/feature/panel.h"
#include "app/gui/frames/edit_row.h"
#include "core/chain/steps.h"

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace underact::gui {

class EditTable;
class NumberTable;

/// Rotations and translations, composed in the listed and in the reverse order, side by side: the resulting frames as
/// matrices, and drawn in the view.
class TransformPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Actions& actions;
    SceneView& view;
  };
  TransformPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  struct State {
    std::vector<chain::Step> steps;
    chain::Axes axes = chain::Axes::Moving;
  };
  void build();
  void buildButtons(QVBoxLayout* column);
  void addCommands();
  bool setStep(int row, const QString& kind, const QString& amount);  // empty: unchanged
  bool setAxes(chain::Axes axes);
  bool change(const State& state);
  int selected() const;
  void refresh();
  void draw();
  std::vector<Pose> frames(bool reversed) const;

  Parts parts_;
  Undoable<State> states_;
  bool drawn_ = false;
  QComboBox* axes_ = nullptr;
  EditTable* table_ = nullptr;
  NumberTable *listed_ = nullptr, *reversed_ = nullptr;
  QLabel *apart_ = nullptr, *told_ = nullptr;
  EditRow buttons_;
};

}  // namespace underact::gui
