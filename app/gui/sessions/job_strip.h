#pragma once
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "app/gui/kit/background.h"
#include "app/gui/sessions/csv_file.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace underact::gui {

class PlotsRun;

/// One long work on a session at a time: how far it is, a button to end it, and what came of it.
class JobStrip : public QWidget {
  Q_OBJECT
 public:
  explicit JobStrip(QWidget* parent = nullptr);
  ~JobStrip() override;
  bool isBusy() const { return csv_ != nullptr || plots_ != nullptr; }
  /// false: another work is going on.
  bool beginCsv(const QString& session, const QString& out);
  bool beginPlots(const QString& session, const QString& out);
  void cancel();
  /// What came of something; alarm: it went wrong.
  void say(const QString& sentence, bool alarm);

 signals:
  void ended();

 private:
  void begin(const QString& sentence, int most);
  void look();
  void end(const QString& sentence, bool alarm);

  std::unique_ptr<Background<CsvFile>> csv_;
  PlotsRun* plots_ = nullptr;
  QString out_;
  QLabel* told_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  QTimer looks_;
};

}  // namespace underact::gui
