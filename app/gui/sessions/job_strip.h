#pragma once
#include <QString>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "app/gui/kit/background.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace underact::gui {

class PlotsRun;

/// What a job ended with.
struct JobResult {
  QString sentence;
  bool is_alarm = false;  // it is an error
  bool is_saved = false;  // it wrote the file
};

/// Runs one long job on a session at a time: shows its progress, a button to cancel it, and its result.
class JobStrip : public QWidget {
  Q_OBJECT
 public:
  explicit JobStrip(QWidget* parent = nullptr);
  ~JobStrip() override;
  bool isBusy() const { return job_ != nullptr || plots_ != nullptr; }
  /// false: another job is running.
  bool beginCsv(const QString& session, const QString& out);
  bool beginPlots(const QString& session, const QString& out);
  bool beginRerun(const QString& session);
  void cancel();
  /// Shows a result; alarm: it is an error.
  void say(const QString& sentence, bool alarm);

 signals:
  void ended();
  /// What was written, and where.
  void saved(const QString& sentence, const QString& path);

 private:
  void begin(const QString& sentence, int max);
  bool beginJob(const QString& sentence, std::function<JobResult(WorkState&)> work);
  void poll();
  void end(const JobResult& result);

  std::unique_ptr<Background<JobResult>> job_;
  PlotsRun* plots_ = nullptr;
  QString out_;  // what the job writes; empty: nothing
  QLabel* told_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  QTimer poll_timer_;
};

}  // namespace underact::gui
