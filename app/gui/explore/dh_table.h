#pragma once
#include <QString>
#include <span>
#include <vector>

#include "app/gui/view/drawing.h"
#include "core/arm/model.h"
#include "core/base/result.h"

namespace underact::gui {

/// A DH table that is tried out: SI, frame 0 in W, the tool in the last frame.
struct DhTable {
  std::vector<chain::DhRow> rows;
  std::vector<double> q;  // of joints that do not follow the arm, rad or m; as many as rows
  Pose X_WB = Pose::Identity();
  Pose X_NT = Pose::Identity();
};

inline constexpr std::size_t kMostDhRows = 8;

/// The columns of the table, in the order of the motions: Rx(alpha) Dx(a) Rz(theta) Dz(d).
enum class DhField { Type, Alpha, A, Theta, D, Q };
inline constexpr int kDhFields = 6;

/// "type", "alpha", "a", "theta", "d", "q": what commands call it; -1: there is none of that name.
int dhFieldOf(const QString& key);
QString headOf(DhField field);
QString tipOf(DhField field);
/// As a cell shows it, mm and degrees.
QString shownText(const DhTable& table, std::size_t row, DhField field);
/// The same with all its digits, as an editor starts from it.
QString exactText(const DhTable& table, std::size_t row, DhField field);
/// The table with a number as it was typed. Problems: it is none; no arm has such a table.
Result<DhTable> withField(DhTable table, std::size_t row, DhField field, const QString& text);

/// A table to start from.
struct DhStart {
  const char* key;
  const char* title;
  DhTable (*make)();
};
/// Textbook arms; the shipped models come beside them.
std::span<const DhStart> dhStarts();
DhTable tableOf(const arm::Model& model);

/// A row more behind the one at index: as long as a hand's breadth, so that it is seen. One fewer: never the last.
DhTable withRow(DhTable table, std::size_t index);
DhTable withoutRow(DhTable table, std::size_t index);

/// Where all frames are with the joints at q; the first is frame 0, the last the tool.
std::vector<Pose> framesOf(const DhTable& table, std::span<const double> q);
/// Its links, joints and frames.
Drawing drawingOf(const DhTable& table, std::span<const double> q);

}  // namespace underact::gui
