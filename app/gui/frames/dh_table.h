#pragma once
#include <QString>
#include <span>
#include <vector>

#include "app/gui/view/drawing.h"
#include "core/arm/model.h"
#include "core/base/result.h"

namespace underact::gui {

/// A DH table to experiment with: SI, frame 0 in W, the tool in the last frame.
struct DhTable {
  std::vector<chain::DhRow> rows;
  std::vector<double> q;  // of joints that do not follow the arm, rad or m; as many as rows
  Pose X_WB = Pose::Identity();
  Pose X_NT = Pose::Identity();
};

inline constexpr std::size_t kMaxDhRows = 8;

/// The columns of the table, in the order of the motions: Rx(alpha) Dx(a) Rz(theta) Dz(d).
enum class DhField { Type, Alpha, A, Theta, D, Q };
inline constexpr int kDhFields = 6;

/// From its name in commands: "type", "alpha", "a", "theta", "d", "q"; -1: no such field.
int dhFieldOf(const QString& key);
QString headOf(DhField field);
QString tipOf(DhField field);
/// As shown in a cell, mm and degrees.
QString shownText(const DhTable& table, std::size_t row, DhField field);
/// The field with all digits, as the initial text of the editor.
QString exactText(const DhTable& table, std::size_t row, DhField field);
/// The table with a field as typed. Problems: not a number; no arm has such a table.
Result<DhTable> withField(DhTable table, std::size_t row, DhField field, const QString& text);

/// A table to start from.
struct DhStart {
  const char* key;
  const char* title;
  DhTable (*make)();
};
/// Textbook arms; the models of the program are listed beside them.
std::span<const DhStart> dhStarts();
DhTable tableOf(const arm::Model& model);

/// A further row after the one at index, 80 mm long, so that it is visible. One fewer: never the last.
DhTable withRow(DhTable table, std::size_t index);
DhTable withoutRow(DhTable table, std::size_t index);

/// The poses of all frames with the joints at q; the first is frame 0, the last the tool.
std::vector<Pose> framesOf(const DhTable& table, std::span<const double> q);
/// Its links, joints and frames.
Drawing drawingOf(const DhTable& table, std::span<const double> q);
/// The four quantities of a row where they are: alpha and a about and along x of the frame before it, theta and d about
/// and along z of its own, q included. Those that are 0 have no place. None: there is no such row.
std::vector<DrawnMeasure> measuresOf(const DhTable& table, std::span<const double> q, std::size_t row);

}  // namespace underact::gui
