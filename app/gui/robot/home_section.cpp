#include <QHeaderView>
#include <QVBoxLayout>

#include "app/gui/arms/joint_fields.h"
#include "app/gui/kit/edit_table.h"
#include "app/gui/kit/words.h"
#include "app/gui/robot/sections.h"

namespace underact::gui {

HomeSection::HomeSection(QWidget* parent)
    : Section("home", tr("Home pose"),
              tr("Pose of the end effector V with all joints at 0: its position, and its orientation as rotations "
                 "about x, then y, then z of W, R = Rz Ry Rx. The tip of the stylus is pulled towards V; the z axis of "
                 "V can follow that of the stylus."),
              parent, "robot"),
      table_(new EditTable("panel.robot.home", tr("Home pose of the end effector"), this)) {
  table_->setRowCount(2);
  table_->setColumnCount(3);
  for (int axis = 0; axis < 3; ++axis) {
    table_->setColumnHead(axis, QString(QChar('x' + axis)), tr("Along and about %1 of W.").arg(QChar('x' + axis)),
                          "−0000.0");
  }
  table_->setVerticalHeaderLabels({tr("position [mm]"), tr("orientation [°]")});
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->fitHeight();
  column().addWidget(table_);
  connect(table_, &EditTable::typed, this, &HomeSection::typed);
}

void HomeSection::present(const Eigen::Matrix4d& X_WV_home, const Vec3& angles_deg) {
  for (int axis = 0; axis < 3; ++axis) {
    const QChar letter('x' + axis);
    const double place_mm = X_WV_home(axis, 3), turn_deg = angles_deg[axis];
    table_->setCell(0, axis,
                    {numberText(place_mm, 1), exactNumber(place_mm), tr("home position, %1, mm").arg(letter),
                     tr("Position of the end effector with all joints at 0, in W.")});
    table_->setCell(
        1, axis,
        {numberText(turn_deg, 1), exactNumber(turn_deg), tr("home orientation, rotation about %1, degrees").arg(letter),
         tr("Orientation of the end effector with all joints at 0: R = Rz Ry Rx.")});
  }
}

}  // namespace underact::gui
