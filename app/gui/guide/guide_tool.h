#pragma once
#include <QObject>
#include <QPointer>
#include <functional>

class QUrl;
class QWidget;

namespace underact::gui {

class Actions;
class GuideWindow;

/// Opens the guide: with F1 at the page for what has the focus. Remembers where it was read last.
class GuideTool : public QObject {
  Q_OBJECT
 public:
  GuideTool(Actions& actions, QString place, int zoom, QWidget* window);

  /// For the settings.
  QString place() const;
  int zoom() const;

 private:
  bool open(const QString& place);
  void follow(const QUrl& link);

  Actions& actions_;
  QString place_;
  int zoom_;
  QWidget* main_;
  QPointer<GuideWindow> window_;
};

}  // namespace underact::gui
