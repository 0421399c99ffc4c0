#pragma once
#include <QDateTime>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace underact::gui {

/// A number checked in a figure, in its own unit; none: it was not a number.
struct FigureNumber {
  QString what, unit;
  std::optional<double> measured, expected, tolerance;
  bool passed = false;
};

/// A figure as written by `underact-cli figures`. Paths are absolute; empty: no such file.
struct FigureRow {
  QString key, title, caption;  // key: its number in the thesis, "4.5"
  QString picture, pdf;         // PNG and PDF
  QString scene, session;
  QString left_out, problem;  // why it has no picture; why it could not be made
  std::vector<FigureNumber> numbers;
  bool passed = false;
};

/// The figures of a folder, with the program version and the time that they were made.
struct FigureList {
  std::vector<FigureRow> rows;
  QString program_version;
  QDateTime made;
};

/// Reads the figures.json of a folder, and its mark. Problems: it is missing or cannot be read.
Result<FigureList> readFigures(const QString& folder);

/// Writes the mark: the version that made the figures of the folder, and when. False: the folder is not writable.
bool markFigures(const QString& folder, const QString& program_version, const QDateTime& made);

/// "all 7 numbers pass", "2 of 7 numbers fail", "picture of the view", "left out", "not made".
QString verdictOf(const FigureRow& row);

/// "25 figures, 97 numbers checked, all pass."
QString verdictOf(const FigureList& list);

}  // namespace underact::gui
