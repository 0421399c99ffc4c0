#include "app/gui/guide/guide_tool.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QUrl>

#include "app/gui/guide/guide_window.h"
#include "app/gui/guide/notebook.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/model/settings.h"
#include "core/system/resource_paths.h"

namespace underact::gui {

GuideTool::GuideTool(Actions& actions, const std::vector<HelpPage>& pages, const Settings& settings,
                     QMainWindow* window)
    : QObject(window),
      actions_(actions),
      pages_(pages),
      place_(settings.guide_page),
      zoom_(settings.guide_zoom),
      main_(window) {
  // If nothing has the focus: the page read last.
  const auto wanted = [this](const QVariantList& arguments) {
    if (!arguments.isEmpty()) return arguments.first().toString();
    const QWidget* focus = QApplication::focusWidget();
    if (window_ != nullptr && focus != nullptr && focus->window() == window_) return QString("window#this-guide");
    return focus == nullptr ? place_ : helpPageOf(focus, pages_);
  };
  actions_.add({"help.guide", tr("&Guide"), QKeySequence("F1"),
                tr("Opens the guide at the page for whatever has the focus."), "help", tr("Guide")},
               [this, wanted](const QVariantList& arguments) { return open(wanted(arguments)); });
  actions_.addChoices([] {
    std::vector<Choice> pages;
    const Result<std::string> folder = system::findResource(system::Resource::Guide);
    const Result<guide::Guide> read = folder ? guide::readGuide(folder.value()) : folder.problems();
    if (!read) return pages;
    for (const guide::Entry& one : read.value().entries)
      pages.push_back(
          {QString::fromStdString(one.page.title), tr("Guide"), "help.guide", QString::fromStdString(one.name)});
    return pages;
  });
  actions_.addCommand("notebook.open", [this](const QVariantList& path) {
    askToOpenNotebook(path.value(0).toString(), main_);
    return true;
  });
  actions_.addCommand("guide.search", [this](const QVariantList& words) {
    if (!open(this->place())) return false;
    window_->search(words.value(0).toString());
    return true;
  });
}

QString GuideTool::place() const {
  return window_ == nullptr ? place_ : window_->place();
}

void GuideTool::remember(Settings& settings) {
  settings.guide_page = place();
  settings.guide_zoom = window_ == nullptr ? zoom_ : window_->zoom();
}

bool GuideTool::open(const QString& place) {
  if (window_ == nullptr) {
    const Result<std::string> folder = system::findResource(system::Resource::Guide);
    Result<guide::Guide> read = folder ? guide::readGuide(folder.value()) : folder.problems();
    if (!read) {
      showProblemsBox("dialog.guide_problems", tr("Guide"), tr("The guide cannot be opened."), read.problems(), main_);
      return false;
    }
    window_ = new GuideWindow(std::move(read).value(), zoom_, main_);
    connect(window_, &GuideWindow::asked, this, &GuideTool::follow);
    connect(window_, &GuideWindow::saved, this, [this](const QString& path) {
      actions_.perform("notice.tell", tr("Saved as %1.").arg(QFileInfo(path).fileName()), path);
    });
  }
  if (!window_->open(place) && window_->place().isEmpty()) window_->open("start");
  window_->show();
  window_->raise();
  window_->activateWindow();
  return true;
}

void GuideTool::follow(const QUrl& link) {
  const QString name = link.path();
  if (link.scheme() == "action") {
    actions_.perform(name);
  } else if (link.scheme() == "lesson") {
    actions_.perform("lesson.start", name);
  } else if (link.scheme() == "scene" && !name.contains('/')) {
    actions_.perform("scene.open", QDir(sceneFolder()).filePath(name + ".json"));
  } else if (link.scheme() == "notebook" && !name.contains('/')) {
    askToOpenNotebook(window_->file(name + ".ipynb"), window_);
  }
}

}  // namespace underact::gui
