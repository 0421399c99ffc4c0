#include "app/gui/gallery/gallery_actions.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QWidget>

#include "app/gui/gallery/gallery_dialog.h"
#include "app/gui/kit/actions.h"

namespace underact::gui {
namespace {

constexpr const char* kReplay = "replay.open";  // exists only in a window that can replay

GalleryCallbacks callbacksFor(Actions& actions, QWidget* window) {
  const auto by = [&actions, window](const QString& action) {
    return [&actions, window, action](const QString& path) {
      actions.perform(action, path);
      window->activateWindow();
    };
  };
  GalleryCallbacks callbacks;
  callbacks.open_scene = by("scene.open");
  if (actions.names().contains(kReplay)) callbacks.open_session = by(kReplay);
  return callbacks;
}

}  // namespace

void addGalleryActions(Actions& actions, QWidget* window) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("underact::gui", text); };
  const auto open = [&actions, window](const QString& only, const QString& folder) {
    auto* dialog = window->findChild<GalleryDialog*>();
    if (dialog == nullptr) {
      dialog = new GalleryDialog(callbacksFor(actions, window), only, window);
      dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->setFolder(folder);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
    return true;
  };
  actions.add({"help.figures",
               tr("&Figures of the thesis"),
               {},
               tr("Shows the figures of the thesis as this program makes them, with their numbers checked.")},
              [open](const QVariantList& only) { return open(only.value(0).toString(), figureFolder()); });
  actions.addCommand("figures.open", [open](const QVariantList& list) {
    return open({}, QFileInfo(list.value(0).toString()).absolutePath());
  });
}

}  // namespace underact::gui
