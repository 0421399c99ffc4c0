#pragma once
#include <QDateTime>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace underact::gui {

/// A number that a figure must show, in its own unit; none: it was no number.
struct FigureNumber {
  QString what, unit;
  std::optional<double> measured, expected, tolerance;
  bool passed = false;
};

/// A figure as `underact-cli figures` left it. Paths are whole; empty: there is none.
struct FigureRow {
  QString key, title, caption;  // key: the thesis's number, "4.5"
  QString picture, pdf;         // PNG and PDF
  QString scene, session;
  QString left_out, problem;  // why it has no picture; what kept it from being made
  std::vector<FigureNumber> numbers;
  bool passed = false;
};

/// The figures of a folder, and who made them when.
struct FigureList {
  std::vector<FigureRow> rows;
  QString program_version;
  QDateTime made;
};

/// Reads the figures.json of a folder, and its mark. Problems: it is not there, or cannot be read.
Result<FigureList> readFigures(const QString& folder);

/// Leaves the mark of who made the figures of folder, and when. False: the folder cannot be written.
bool markFigures(const QString& folder, const QString& program_version, const QDateTime& made);

/// "all 7 numbers pass", "2 of 7 numbers fail", "picture of the view", "left out", "not made".
QString verdictOf(const FigureRow& row);

/// "25 figures, 97 numbers checked, all pass."
QString verdictOf(const FigureList& list);

}  // namespace underact::gui
