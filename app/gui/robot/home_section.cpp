#include <QHeaderView>
#include <QVBoxLayout>

#include "app/gui/arms/joint_fields.h"
#include "app/gui/kit/edit_table.h"
#include "app/gui/kit/words.h"
#include "app/gui/robot/sections.h"

namespace underact::gui {

HomeSection::HomeSection(QWidget* parent)
    : Section("home", tr("Tip at home"),
              tr("Where the tip V is while all joints are at 0, and how it is turned: about x, then y, then z of W, "
                 "R = Rz Ry Rx. The stylus is drawn to V, and its z to V's."),
              parent, "robot"),
      table_(new EditTable("panel.robot.home", tr("The robot's tip at home"), this)) {
  table_->setRowCount(2);
  table_->setColumnCount(3);
  for (int axis = 0; axis < 3; ++axis) {
    table_->setColumnHead(axis, QString(QChar('x' + axis)), tr("Along, and about, %1 of W.").arg(QChar('x' + axis)),
                          "−0000.0");
  }
  table_->setVerticalHeaderLabels({tr("place [mm]"), tr("turn [°]")});
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
                    {numberText(place_mm, 1), exactNumber(place_mm), tr("tip at home, %1, mm").arg(letter),
                     tr("Where the tip is at home, in W.")});
    table_->setCell(
        1, axis,
        {numberText(turn_deg, 1), exactNumber(turn_deg), tr("turn of the tip about %1, degrees").arg(letter),
         tr("How the tip is turned at home: R = Rz Ry Rx.")});
  }
}

}  // namespace underact::gui
