#include "app/gui/frames/dh_table.h"

#include <QCoreApplication>
#include <array>
#include <cmath>

#include "app/gui/arms/joint_fields.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"
#include "core/chain/table_check.h"

namespace underact::gui {
namespace {

using chain::DhRow;
using chain::JointType;

constexpr double kRight = kPi / 2;
constexpr double kNewLink_m = 0.08, kAxis_m = 0.02;

struct DhFieldRow {
  const char *key, *head, *tip;
};
constexpr std::array<DhFieldRow, kDhFields> kRows{
    {{"type", QT_TRANSLATE_NOOP("explore", "joint"),
      QT_TRANSLATE_NOOP("explore", "R, revolute: q adds to θ. P, prismatic: q adds to d.")},
     {"alpha", QT_TRANSLATE_NOOP("explore", "α\n[°]"),
      QT_TRANSLATE_NOOP("explore",
                        "Twist: the angle from the previous z axis to that of this row, about the previous x axis.")},
     {"a", QT_TRANSLATE_NOOP("explore", "a\n[mm]"),
      QT_TRANSLATE_NOOP(
          "explore", "Length: the distance from the previous z axis to that of this row, along the previous x axis.")},
     {"theta", QT_TRANSLATE_NOOP("explore", "θ\n[°]"),
      QT_TRANSLATE_NOOP("explore",
                        "Angle: from the previous x axis to that of this row, about z, with the joint at 0.")},
     {"d", QT_TRANSLATE_NOOP("explore", "d\n[mm]"),
      QT_TRANSLATE_NOOP(
          "explore",
          "Offset: the distance from the previous x axis to that of this row, along z, with the joint at 0.")},
     {"q", QT_TRANSLATE_NOOP("explore", "q\n[° mm]"),
      QT_TRANSLATE_NOOP("explore",
                        "The value of the joint: from the arm if the joints follow it, otherwise as typed.")}}};

QString word(const char* text) {
  return QCoreApplication::translate("explore", text);
}

bool turns(const DhRow& row) {
  return row.type == JointType::Revolute;
}

/// The number behind a cell.
double& numberOf(DhTable& table, std::size_t row, DhField field) {
  DhRow& one = table.rows[row];
  if (field == DhField::Alpha) return one.alpha_rad;
  if (field == DhField::A) return one.a_m;
  if (field == DhField::Theta) return one.theta_rad;
  return field == DhField::D ? one.d_m : table.q[row];
}

double fieldUnit(const DhRow& row, DhField field) {
  const bool angle = field == DhField::Alpha || field == DhField::Theta || (field == DhField::Q && turns(row));
  return angle ? 1.0 / kRadPerDegree : kMillimetrePerMetre;
}

double onScreen(const DhTable& table, std::size_t row, DhField field) {
  return fieldUnit(table.rows[row], field) * numberOf(const_cast<DhTable&>(table), row, field);
}

DhTable madeOf(std::vector<DhRow> rows) {
  DhTable table;
  table.q.assign(rows.size(), 0.0);
  table.rows = std::move(rows);
  table.X_WB = arm::models().front().X_WB;
  return table;
}

DhTable planar() {
  return madeOf({{JointType::Revolute}, {JointType::Revolute, 0.0, 0.10}, {JointType::Revolute, 0.0, 0.08}});
}

DhTable scara() {
  return madeOf({{JointType::Revolute, 0.0, 0.0, 0.0, 0.10},
                 {JointType::Revolute, 0.0, 0.10},
                 {JointType::Revolute, 0.0, 0.08},
                 {JointType::Prismatic, kPi, 0.0, 0.0, 0.03}});
}

DhTable spherical() {  // of the kind of Craig, figure 3.36: two revolute joints and a prismatic one
  return madeOf(
      {{JointType::Revolute}, {JointType::Revolute, -kRight}, {JointType::Prismatic, kRight, 0.0, 0.0, 0.10}});
}

}  // namespace

int dhFieldOf(const QString& key) {
  for (int field = 0; field < kDhFields; ++field) {
    if (key == kRows[static_cast<std::size_t>(field)].key) return field;
  }
  return -1;
}

QString headOf(DhField field) {
  return word(kRows[static_cast<std::size_t>(field)].head);
}

QString tipOf(DhField field) {
  return word(kRows[static_cast<std::size_t>(field)].tip);
}

QString shownText(const DhTable& table, std::size_t row, DhField field) {
  if (field == DhField::Type) return turns(table.rows[row]) ? QStringLiteral("R") : QStringLiteral("P");
  return numberText(onScreen(table, row, field), 1);
}

QString exactText(const DhTable& table, std::size_t row, DhField field) {
  if (field == DhField::Type) return turns(table.rows[row]) ? QObject::tr("revolute") : QObject::tr("prismatic");
  return exactNumber(onScreen(table, row, field));
}

Result<DhTable> withField(DhTable table, std::size_t row, DhField field, const QString& text) {
  if (row >= table.rows.size()) return Problems{{phrase(QT_TRANSLATE_NOOP("problem", "There is no such row."))}};
  DhRow& one = table.rows[row];
  if (field == DhField::Type) {
    const bool slides = text == QObject::tr("prismatic") || text == QLatin1String("prismatic");
    if (!slides && text != QObject::tr("revolute") && text != QLatin1String("revolute"))
      return Problems{{phrase(QT_TRANSLATE_NOOP("problem", "A joint is revolute or prismatic."))}};
    one.type = slides ? JointType::Prismatic : JointType::Revolute;
    one.min = -kInfinity;  // the limits have the other unit
    one.max = kInfinity;
    table.q[row] = 0.0;
    return table;
  }
  const Result<double> number = typedNumber(text);
  if (!number) return number.problems();
  numberOf(table, row, field) = number.value() / fieldUnit(one, field);
  const Problems problems = chain::tableErrors(table.rows);
  if (!problems.empty()) return problems;
  return table;
}

std::span<const DhStart> dhStarts() {
  static constexpr std::array<DhStart, 3> kStarts{
      {{"planar", QT_TRANSLATE_NOOP("explore", "Two links in a plane"), planar},
       {"scara", QT_TRANSLATE_NOOP("explore", "SCARA"), scara},
       {"spherical", QT_TRANSLATE_NOOP("explore", "Two revolute, one prismatic"), spherical}}};
  return kStarts;
}

DhTable tableOf(const arm::Model& model) {
  DhTable table;
  table.rows.assign(model.rows.begin(), model.rows.end());
  table.q.assign(model.rows.size(), 0.0);
  table.X_WB = model.X_WB;
  table.X_NT = model.X_NT;
  return table;
}

DhTable withRow(DhTable table, std::size_t index) {
  if (table.rows.size() >= kMaxDhRows) return table;
  const auto at = static_cast<std::ptrdiff_t>(std::min(index + 1, table.rows.size()));
  table.rows.insert(table.rows.begin() + at, DhRow{JointType::Revolute, 0.0, kNewLink_m});
  table.q.insert(table.q.begin() + at, 0.0);
  return table;
}

DhTable withoutRow(DhTable table, std::size_t index) {
  if (table.rows.size() < 2 || index >= table.rows.size()) return table;
  table.rows.erase(table.rows.begin() + static_cast<std::ptrdiff_t>(index));
  table.q.erase(table.q.begin() + static_cast<std::ptrdiff_t>(index));
  return table;
}

std::vector<Pose> framesOf(const DhTable& table, std::span<const double> q) {
  std::vector<Pose> frames(table.rows.size());
  chain::framesOf(table.rows, table.X_WB, q, frames);
  frames.insert(frames.begin(), table.X_WB);
  frames.push_back(frames.back() * table.X_NT);
  return frames;
}

Drawing drawingOf(const DhTable& table, std::span<const double> q) {
  const std::vector<Pose> frames = framesOf(table, q);
  Drawing drawing;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const Pose &before = frames[row], &here = frames[row + 1];
    // Along x to the joint's axis, and along the axis to the frame.
    const Vec3 foot_W = before.translation() + table.rows[row].a_m * before.linear().col(0);
    drawing.links.push_back({before.translation(), foot_W});
    drawing.links.push_back({foot_W, here.translation(), table.rows[row].type == JointType::Prismatic});
    drawing.joints.push_back({table.rows[row].type, foot_W, here.linear().col(2)});
    drawing.frames.push_back({here, QString("{%1}").arg(row + 1), kAxis_m, false});
  }
  drawing.links.push_back({frames[table.rows.size()].translation(), frames.back().translation()});
  return drawing;
}

std::vector<DrawnMeasure> measuresOf(const DhTable& table, std::span<const double> q, std::size_t row) {
  constexpr double kNoLength_m = 1e-5, kNoAngle_rad = 1e-4, kArcOfAlpha_m = 0.020, kArcOfTheta_m = 0.016;
  std::vector<DrawnMeasure> measures;
  if (row >= table.rows.size() || row >= q.size()) return measures;
  const std::vector<Pose> frames = framesOf(table, q);
  const Pose &before = frames[row], &here = frames[row + 1];
  const DhRow& dh = table.rows[row];
  const bool slides = dh.type == JointType::Prismatic;
  const double theta_rad = dh.theta_rad + (slides ? 0.0 : q[row]), d_m = dh.d_m + (slides ? q[row] : 0.0);
  const Vec3 x_W = before.linear().col(0), z_W = here.linear().col(2);
  const Vec3 foot_W = before.translation() + dh.a_m * x_W;
  const auto turn = [&](const QString& letter, int axis, const Vec3& leg_W, double angle_rad, const Vec3& about_W) {
    if (std::abs(angle_rad) < kNoAngle_rad) return;
    measures.push_back({QStringLiteral("%1 %2°").arg(letter, numberText(angle_rad / kRadPerDegree, 1)), axis, foot_W,
                        leg_W, angle_rad, about_W});
  };
  const auto length = [&](const QString& letter, int axis, const Vec3& from_W, const Vec3& to_end_W, double length_m) {
    if (std::abs(length_m) < kNoLength_m) return;
    measures.push_back({QStringLiteral("%1 %2 mm").arg(letter, numberText(kMillimetrePerMetre * length_m, 1)), axis,
                        from_W, to_end_W});
  };
  turn(QStringLiteral("α"), 0, kArcOfAlpha_m * before.linear().col(2), dh.alpha_rad, x_W);
  length(QStringLiteral("a"), 0, before.translation(), dh.a_m * x_W, dh.a_m);
  turn(QStringLiteral("θ"), 2, kArcOfTheta_m * x_W, theta_rad, z_W);
  length(QStringLiteral("d"), 2, foot_W, d_m * z_W, d_m);
  return measures;
}

}  // namespace underact::gui
