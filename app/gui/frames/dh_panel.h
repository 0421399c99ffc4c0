#pragma once
#include <vector>

#include "app/gui/feature/panel.h"
#include "app/gui/frames/dh_table.h"
#include "app/gui/frames/edit_row.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QVBoxLayout;

namespace underact::gui {

class EditTable;
class NumberTable;

/// A DH table to edit, drawn in the view at the arm's joint angles: with the table of the arm it covers the arm, and
/// each wrong number moves it away.
class DhPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    Actions& actions;
    SceneView& view;
  };
  DhPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void build();
  void buildButtons(QVBoxLayout* column);
  void addCommands();
  bool start(const QString& key);  // of a textbook arm, of a model; "": the scene's arm
  void followScene();
  bool type(int row, int field, const QString& text);
  bool change(const DhTable& table);
  bool follow(bool on);
  std::size_t selected() const;
  std::vector<double> joints(bool follow) const;  // those of the arm, or as typed
  void showTable();
  void showNumbers();
  void draw();

  Parts parts_;
  Undoable<DhTable> tables_;
  arm::Geometry of_scene_;      // of the arm whose table was begun with last
  arm::JointAngles q_rad_{};    // of the arm
  Vec3 p_WT_ = Vec3::Zero();    // position of its tip
  std::int64_t shown_ns_ = -1;  // time of the numbers shown
  bool drawn_ = false;
  QComboBox* start_ = nullptr;
  EditTable* table_ = nullptr;
  QCheckBox* follows_ = nullptr;
  NumberTable* tip_ = nullptr;
  QLabel *odd_ = nullptr, *told_ = nullptr;
  EditRow buttons_;
};

}  // namespace underact::gui
