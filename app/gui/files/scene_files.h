#pragma once
#include <QObject>
#include <QString>

#include "core/base/result.h"
#include "core/scene/description.h"

class QWidget;

namespace underact::gui {

class Document;
class LoadStrip;
class ProblemsDialog;
class RecentFiles;

/// Opens and saves scenes, with the dialogs that belong to it.
class SceneFiles : public QObject {
  Q_OBJECT
 public:
  SceneFiles(Document& document, RecentFiles& recent, LoadStrip& loads, QWidget* window);

  /// Asks about edits first. A scene with meshes opens when they have been loaded in another thread; until then the
  /// previous one stays. false: there are problems (they are shown), or the user cancelled.
  bool open(const QString& path);
  /// A scene whose meshes are loaded, with or without a file; asks the same questions.
  bool openLoaded(scene::Description scene);
  void chooseAndOpen();
  bool saveAs(const QString& path);
  void chooseAndSave();
  /// Asks what to do with unsaved edits, if any. false: the user cancelled.
  bool settleEdits();

 signals:
  void saved(const QString& path);

 private:
  bool saveBeforeLeaving();
  bool put(scene::Description scene);
  void loadAndPut(scene::Description scene);

  Document& document_;
  RecentFiles& recent_;
  LoadStrip& loads_;
  QWidget* window_;
  ProblemsDialog* problems_;
};

}  // namespace underact::gui
