#include "app/gui/files/constraint_files.h"

#include <QFileInfo>
#include <QPointer>
#include <optional>
#include <utility>

#include "app/gui/files/add_dialog.h"
#include "app/gui/files/load_strip.h"
#include "app/gui/files/scene_files.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "core/scene/edit.h"

namespace underact::gui {

ConstraintFiles::ConstraintFiles(ConstraintFileKind kind, Document& document, SceneFiles& scenes, LoadStrip& loads,
                                 QWidget* window)
    : QObject(window), kind_(std::move(kind)), document_(document), scenes_(scenes), loads_(loads), window_(window) {}

void ConstraintFiles::addAction(Actions& actions, const ActionInfo& info) {
  connect(this, &ConstraintFiles::added, &actions, [&actions] { actions.perform("view.fit"); });
  actions.add(info, [this](const QVariantList& path) {
    if (path.isEmpty())
      choose();
    else
      load(path.first().toString(), kind_.read);
    return true;
  });
}

void ConstraintFiles::choose() {
  QStringList patterns;
  for (const QString& suffix : kind_.suffixes) patterns << "*." + suffix << "*." + suffix.toUpper();
  askForFile(window_, qPrintable("dialog.add_" + kind_.key), kind_.choose, {}, kind_.filter.arg(patterns.join(' ')),
             [this](const QString& path) { load(path, kind_.read); });
}

void ConstraintFiles::load(const QString& path, const ConstraintFileKind::Read& read) {
  const auto outcome = std::make_shared<std::optional<Result<ConstraintFileKind::Ask>>>();
  const QString name = QFileInfo(path).fileName();
  loads_.begin(
      tr("Loading %1").arg(name), [outcome, path, read](const TaskMonitor& monitor) { *outcome = read(path, monitor); },
      [this, outcome, name] {
        if (**outcome) return ask(name, (**outcome).value()(document_.isOpen(), window_));
        const QString what = tr("“%1” was not loaded. The scene is unchanged.").arg(name);
        showProblemsBox(QString("dialog.%1_problems").arg(kind_.key), kind_.not_loaded, what, (**outcome).problems(),
                        window_);
      });
}

void ConstraintFiles::ask(const QString& name, AddDialog* dialog) {
  const auto tell = [this](bool is_added) {
    if (is_added) emit added();
    return is_added;
  };
  connect(dialog, &AddDialog::addAsked, this, [this, name, dialog, tell] {
    take(name, dialog, [this, name, tell](AddDialog& asked, const scene::Constraint& constraint) {
      const scene::Description with = scene::withAdded(document_.scene(), document_.throughMirror(constraint));
      const Problems problems = document_.edit(with, kind_.edit.arg(name), document_.newGesture());
      asked.setRefusal(sentencesOf(problems));
      return tell(problems.empty());
    });
  });
  connect(dialog, &AddDialog::newSceneAsked, this, [this, name, dialog, tell] {
    take(name, dialog, [this, name, tell](AddDialog&, const scene::Constraint& constraint) {
      scene::Description scene;
      scene.title = constraint.name;
      scene.about = kind_.about.arg(name).toStdString();
      scene.constraints.push_back(constraint);
      return tell(scenes_.openLoaded(std::move(scene)));
    });
  });
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

void ConstraintFiles::take(const QString& name, AddDialog* dialog, const Use& use) {
  const scene::Constraint constraint = dialog->constraint();
  if (!kind_.make) {
    if (use(*dialog, constraint)) dialog->close();
    return;
  }
  const auto made = std::make_shared<std::optional<Result<ConstraintFileKind::Made>>>();
  loads_.begin(
      tr("Adding %1").arg(name),
      [made, make = kind_.make, shape = document_.throughMirror(constraint).shape](const TaskMonitor&) {
        *made = make(shape);
      },
      [made, constraint, use, asked = QPointer<AddDialog>(dialog)] {
        if (asked == nullptr) return;  // closed meanwhile: no longer wanted
        if (!**made)
          asked->setRefusal(sentencesOf((**made).problems()));
        else if (use(*asked, constraint))
          asked->close();
      });
}

}  // namespace underact::gui
