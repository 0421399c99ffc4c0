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

/// Opening and saving, with the questions and the answers that go with it.
class SceneFiles : public QObject {
  Q_OBJECT
 public:
  SceneFiles(Document& document, RecentFiles& recent, LoadStrip& loads, QWidget* window);

  /// Asks about edits first. A scene with meshes opens when they are loaded, in another thread; the one before it stays
  /// until then. false: there are problems (they are shown), or the user thought better of it.
  bool open(const QString& path);
  /// A scene with its meshes, of a file or of none; the same questions.
  bool openLoaded(scene::Description scene);
  void chooseAndOpen();
  bool saveAs(const QString& path);
  void chooseAndSave();
  /// Nothing is edited, or the user says what becomes of it. false: everything stays as it is.
  bool settleEdits();

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
