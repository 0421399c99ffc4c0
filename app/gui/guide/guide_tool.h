#pragma once
#include <QObject>
#include <QPointer>

#include "app/gui/feature/feature.h"

class QUrl;
class QWidget;

namespace underact::gui {

class GuideWindow;

/// Opens the guide, with F1 at the page for what has the focus. Remembers the page read last.
class GuideTool : public QObject, public ServoListener {
  Q_OBJECT
 public:
  GuideTool(Actions& actions, const std::vector<HelpPage>& pages, const Settings& settings, QMainWindow* window);
  void remember(Settings& settings) override;

 private:
  QString place() const;
  bool open(const QString& place);
  void follow(const QUrl& link);

  Actions& actions_;
  const std::vector<HelpPage>& pages_;
  QString place_;
  int zoom_;
  QWidget* main_;
  QPointer<GuideWindow> window_;
};

}  // namespace underact::gui
