#pragma once
#include <QObject>

#include "core/base/result.h"

class QWidget;

namespace underact::gui {

class Document;
class ProblemsDialog;
class RecentFiles;

/// Opening and saving, with the questions and the answers that go with it.
class SceneFiles : public QObject {
  Q_OBJECT
 public:
  SceneFiles(Document& document, RecentFiles& recent, QWidget* window);

  /// Asks about edits first. false: there are problems (they are shown), or the user thought better of it.
  bool open(const QString& path);
  void chooseAndOpen();
  bool saveAs(const QString& path);
  void chooseAndSave();
  /// Nothing is edited, or the user says what becomes of it. false: everything stays as it is.
  bool settleEdits();

 private:
  bool saveBeforeLeaving();

  Document& document_;
  RecentFiles& recent_;
  QWidget* window_;
  ProblemsDialog* problems_;
};

}  // namespace underact::gui
