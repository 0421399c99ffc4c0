#include "app/gui/window/window_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QFileInfo>
#include <QMainWindow>

#include "app/gui/arms/second_arm.h"
#include "app/gui/files/scene_files.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/left_hand.h"
#include "app/gui/window/purpose.h"

namespace underact::gui {
namespace {

void addServo(const FeatureParts& parts) {
  SecondArm& second = parts.second;
  Actions& actions = parts.actions;
  parts.actions.add(
      {"session.start", tr("&Start"), QKeySequence("F5"), tr("Starts the servo, also after a fault."), "start"},
      [control = parts.control, &second](const QVariantList&) {
        control.start();
        second.start();
        return true;
      });
  parts.actions.add(
      {"session.stop", tr("S&top"), QKeySequence("Esc"),
       tr("Stops the servo: the force goes to zero. Shift+Esc does so in an open menu or dialog, too."), "stop"},
      [control = parts.control, &second, &actions](const QVariantList&) {
        control.stop();
        second.stop();
        actions.perform("service.hold");  // no program starts again what a person has stopped
        return true;
      });
}

/// Whoever opens a file, from a dialog, by a drop or on the command line, comes here.
bool openFile(const QString& path, Actions& actions, SceneFiles& files, const std::vector<FeatureRow>& rows,
              QWidget* window) {
  const Result<FileKind> kind = kindOfFile(path.toStdString());
  if (!kind) {
    showProblemsBox("dialog.open_problems", tr("File not opened"),
                    tr("“%1” was not opened.").arg(QFileInfo(path).fileName()), kind.problems(), window);
    return false;
  }
  const QString opener = openerOf(kind.value(), rows);
  return opener.isEmpty() ? files.open(path) : actions.perform(opener, path);
}

void addFiles(const FeatureParts& parts, const std::vector<FeatureRow>& rows) {
  Actions& actions = parts.actions;
  SceneFiles& files = parts.files;
  QObject::connect(&files, &SceneFiles::saved, &actions, [&actions](const QString& path) {
    actions.perform("notice.tell", tr("Scene saved as %1.").arg(QFileInfo(path).fileName()), path);
  });
  QObject::connect(&files, &SceneFiles::tunedAgain, &actions, [&actions] {
    actions.perform("notice.tell", tr("Opened with your last settings. Undo (Ctrl+Z) restores the original."),
                    QString());
  });
  QObject::connect(&files, &SceneFiles::chosen, &actions,
                   [&actions](const QString& path) { actions.perform("scene.open", path); });
  actions.add({"scene.open", tr("&Open file…"), QKeySequence::Open,
               tr("Opens a scene, session, arm file, mesh, curve, lesson, list of figures or notebook."), "open"},
              [&actions, &files, rows, window = parts.window](const QVariantList& path) {
                if (path.isEmpty()) {
                  files.chooseAndOpen();
                  return true;
                }
                return openFile(path.first().toString(), actions, files, rows, window);
              });
  actions.addCommand("scene.settle", [&files](const QVariantList&) { return files.settleEdits(); });
  addLeftHandAction(actions, parts.document);
  actions
      .add({"scene.save_as", tr("&Save tuned scene as…"), QKeySequence::Save,
            tr("Saves the scene with its current settings."), "save", tr("Save as…")},
           [&files](const QVariantList& path) {
             if (!path.isEmpty()) return files.saveAs(path.first().toString());
             files.chooseAndSave();
             return true;
           })
      ->setEnabled(false);
  actions.add({"app.quit", tr("&Quit"), QKeySequence("Ctrl+Q"), tr("Stops the servo and closes the window.")},
              [window = parts.window](const QVariantList&) { return window->close(); });
}

/// text: of the menu entry when there is nothing to undo; with: the pattern with what would be undone.
void follow(QAction* action, const QString& text, const QString& with, const QString& what) {
  action->setText(what.isEmpty() ? text : with.arg(menuText(what)));
  action->setIconText(QString(text).remove('&'));
}

void addUndo(Actions& actions, QUndoStack& undo) {
  QAction* back = actions.add(
      {"edit.undo", tr("&Undo"), QKeySequence::Undo, tr("Undoes the last change to the scene."), "undo", tr("Undo")},
      [&undo](const QVariantList&) {
        undo.undo();
        return true;
      });
  QAction* forth = actions.add({"edit.redo", tr("&Redo"), QKeySequence("Ctrl+Shift+Z"),
                                tr("Redoes the change that was undone."), "redo", tr("Redo")},
                               [&undo](const QVariantList&) {
                                 undo.redo();
                                 return true;
                               });
  back->setEnabled(false);
  forth->setEnabled(false);
  QObject::connect(&undo, &QUndoStack::canUndoChanged, back, &QAction::setEnabled);
  QObject::connect(&undo, &QUndoStack::canRedoChanged, forth, &QAction::setEnabled);
  QObject::connect(&undo, &QUndoStack::undoTextChanged, back,
                   [back](const QString& what) { follow(back, tr("&Undo"), tr("&Undo %1"), what); });
  QObject::connect(&undo, &QUndoStack::redoTextChanged, forth,
                   [forth](const QString& what) { follow(forth, tr("&Redo"), tr("&Redo %1"), what); });
}

void addPurposeActions(Actions& actions, const std::function<void(const QString&)>& choose) {
  auto* const group = new QActionGroup(&actions);
  for (const Purpose& one : purposes()) {
    const auto words = [](const char* text) { return QCoreApplication::translate("purpose", text); };
    QAction* const action =
        actions.add({QString("purpose.%1").arg(one.key), words(one.title), {}, words(one.tip), {}, {}, true},
                    [choose, key = QString(one.key)](const QVariantList& on) {
                      if (on.value(0).toBool()) choose(key);
                      return true;
                    });
    group->addAction(action);
  }
}

}  // namespace

void addWindowActions(const FeatureParts& parts, const std::vector<FeatureRow>& rows,
                      const std::function<void()>& arrange, const std::function<void(const QString&)>& choose) {
  addServo(parts);
  addFiles(parts, rows);
  addUndo(parts.actions, parts.document.undoStack());
  addPurposeActions(parts.actions, choose);
  parts.actions.add({"menu.layers", tr("La&yers"), {}, tr("Shows or hides parts of the view."), "layers", tr("Layers")},
                    [](const QVariantList&) { return true; });
  parts.actions.add({"menu.panels", tr("All panels"), {}, tr("Shows or hides any panel."), "more", tr("All panels")},
                    [](const QVariantList&) { return true; });
  parts.actions.add({"layout.reset", tr("&Reset the layout"), {}, tr("Restores the default layout of the panels.")},
                    [arrange, &actions = parts.actions](const QVariantList&) {
                      arrange();
                      actions.perform("layer.ghosts", false);
                      return true;
                    });
}

}  // namespace underact::gui
