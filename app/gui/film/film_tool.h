#pragma once
#include <QPointer>
#include <QProcess>
#include <QProgressDialog>

#include "app/gui/feature/feature.h"

namespace underact::gui {

/// Films the scene in the window, or the session that is open, in a program of its own, so that the servo and the view
/// go on meanwhile.
class FilmTool : public QObject, public ServoListener {
  Q_OBJECT
 public:
  explicit FilmTool(const FeatureParts& parts);
  ~FilmTool() override;  // ends the filming
  QString busyReason() const override;

 private:
  bool ask();
  bool begin(const QString& out);
  void read();
  void end(int code, QProcess::ExitStatus status);

  Actions& actions_;
  Document& document_;
  Player& player_;
  QMainWindow* window_;
  QProcess process_;
  QPointer<QProgressDialog> progress_;
  QString out_, last_line_;
};

}  // namespace underact::gui
