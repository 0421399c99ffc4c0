#pragma once
#include <QLockFile>
#include <QObject>
#include <QString>

#include "app/gui/kit/cli_process.h"

namespace underact::gui {

/// Where the figures are kept between runs of the program.
QString figureFolder();

/// Runs `underact-cli figures` in its own process to make the figures of a folder. The old ones stay until the new ones
/// are complete.
class FiguresRun : public QObject {
  Q_OBJECT
 public:
  enum class End { Made, Cancelled, Failed };

  /// only: figure numbers separated by commas; empty: all.
  FiguresRun(const QString& folder, const QString& only, QObject* parent);
  ~FiguresRun() override;  // cancels the run
  void begin();
  void cancel();

 signals:
  /// The figure being made: number from 1 to of.
  void progressed(int number, int of, const QString& figure);
  /// Made: the folder holds the new figures (whose numbers may fail). sentence: why not.
  void finished(underact::gui::FiguresRun::End end, const QString& sentence);

 private:
  void end(std::optional<int> code);
  QString keep();
  QString refusalReason() const;

  QString folder_, fresh_, only_;
  QLockFile lock_;
  CliProcess process_;
  bool cancelled_ = false;
};

}  // namespace underact::gui
