#pragma once
#include <QDateTime>
#include <QObject>

#include "app/gui/kit/cli_process.h"

namespace underact::gui {

/// Draws all plots of a session, by `underact-cli log plot`. Each is a file with its kind in the name: for trial.pdf
/// trial_error.pdf, trial_force.pdf and so on.
class PlotsRun : public QObject {
  Q_OBJECT
 public:
  PlotsRun(const QString& session, const QString& out, QObject* parent);  // destroying it ends the job early
  void begin();
  void cancel();

 signals:
  /// sentence: the result.
  void finished(bool done, const QString& sentence);

 private:
  void end(std::optional<int> code);
  int drawn() const;  // files
  QString session_, out_;
  QDateTime began_;
  CliProcess process_;
  bool cancelled_ = false;
};

}  // namespace underact::gui
