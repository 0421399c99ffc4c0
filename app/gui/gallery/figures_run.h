#pragma once
#include <QLockFile>
#include <QObject>
#include <QString>

#include "app/gui/kit/cli_process.h"

namespace underact::gui {

/// Where the figures are kept between two starts.
QString figureFolder();

/// Has `underact-cli figures` remake the figures of a folder, in a process of its own. What the folder held stays until
/// the new figures are whole.
class FiguresRun : public QObject {
  Q_OBJECT
 public:
  enum class End { Made, Cancelled, Failed };

  /// only: numbers of figures with commas between; empty: all.
  FiguresRun(const QString& folder, const QString& only, QObject* parent);
  ~FiguresRun() override;  // ends it early
  void begin();
  void cancel();

 signals:
  /// Which figure is made now: number from 1 to of.
  void progressed(int number, int of, const QString& figure);
  /// Made: the folder holds the new figures (which may show other numbers than they should). sentence: why not.
  void finished(underact::gui::FiguresRun::End end, const QString& sentence);

 private:
  void end(std::optional<int> code);
  QString keep();
  QString whyNot() const;

  QString folder_, fresh_, only_;
  QLockFile lock_;
  CliProcess process_;
  bool cancelled_ = false;
};

}  // namespace underact::gui
