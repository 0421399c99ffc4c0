#pragma once
#include <QObject>
#include <QString>
#include <optional>

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
  /// Asks for any file that the window opens, see chosen().
  void chooseAndOpen();
  bool saveAs(const QString& path);
  void chooseAndSave();
  /// Asks what to do with unsaved edits, if any; those of a scene that came with the program are kept for the next time
  /// instead. false: the user cancelled.
  bool settleEdits();

 signals:
  void chosen(const QString& path);  // a file to be opened
  void saved(const QString& path);
  void tunedAgain();  // a scene was opened as it was left

 private:
  bool saveBeforeLeaving();
  /// As in its file, and as it was left last, if otherwise.
  struct Read {
    scene::Description scene;
    std::optional<scene::Description> tuned = {};
  };
  bool put(Read read);
  void loadAndPut(Read read);
  bool keepTuning() const;

  Document& document_;
  RecentFiles& recent_;
  LoadStrip& loads_;
  QWidget* window_;
  ProblemsDialog* problems_;
  QString tunable_;  // the file of the scene that was opened, if nobody saves that one
};

}  // namespace underact::gui
