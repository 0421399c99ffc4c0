#pragma once
#include <QDateTime>
#include <QObject>
#include <QProcess>

namespace underact::gui {

/// The folder of the Python package that ships with the program; empty: it is not there.
QString pythonFolder();

/// Draws all plots of a session, by the Python package, in a process of its own. Each is a file with its kind in the
/// name: for trial.pdf trial_error.pdf, trial_force.pdf and so on.
class PlotsRun : public QObject {
  Q_OBJECT
 public:
  PlotsRun(const QString& session, const QString& out, QObject* parent);
  ~PlotsRun() override;  // ends it early
  void begin();
  void cancel();

 signals:
  /// sentence: what came of it.
  void finished(bool done, const QString& sentence);

 private:
  int drawn() const;  // files
  QString whyNot();
  QString session_, out_;
  QDateTime began_;
  QProcess process_;
  bool cancelled_ = false;
};

}  // namespace underact::gui
