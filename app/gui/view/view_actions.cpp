#include "app/gui/view/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/theme.h"
#include "app/gui/kit/words.h"
#include "app/gui/view/scene_view.h"

namespace underact::gui {
namespace {

void addCameras(Actions& actions, SceneView& view) {
  struct Row {
    const char *name, *text, *shortcut, *tip, *icon, *button;
    Camera camera;
  };
  const Row rows[] = {
      {"view.fit", QT_TR_NOOP("&Fit"), "Ctrl+0", QT_TR_NOOP("Shows the whole scene from the current direction."), "fit",
       QT_TR_NOOP("Fit"), Camera::Fit},
      {"view.front", QT_TR_NOOP("F&ront"), "Ctrl+1", QT_TR_NOOP("Looks from the front, where the hand is, along −z."),
       "front", QT_TR_NOOP("Front"), Camera::Front},
      {"view.top", QT_TR_NOOP("&Top"), "Ctrl+2", QT_TR_NOOP("Looks down, along −y."), "top", QT_TR_NOOP("Top"),
       Camera::Top},
      {"view.side", QT_TR_NOOP("&Side"), "Ctrl+3", QT_TR_NOOP("Looks from the right, along −x."), "side",
       QT_TR_NOOP("Side"), Camera::Right},
      {"view.isometric", QT_TR_NOOP("&Isometric"), "Ctrl+4", QT_TR_NOOP("Looks from the front right and above."),
       "isometric", QT_TR_NOOP("Isometric"), Camera::Isometric},
      {"view.left", QT_TR_NOOP("&Left"), "Ctrl+5", QT_TR_NOOP("Looks from the left, along x."), "", "", Camera::Left},
      {"view.back", QT_TR_NOOP("&Back"), "Ctrl+6", QT_TR_NOOP("Looks from behind the arm, along z."), "", "",
       Camera::Back},
      {"view.home", QT_TR_NOOP("Home (defa&ult view)"), "Ctrl+8",
       QT_TR_NOOP("Looks as at the start: from the front, a little from the right and above."), "", "", Camera::Home},
      {"view.bottom", QT_TR_NOOP("B&ottom"), "Ctrl+7", QT_TR_NOOP("Looks up, along y."), "", "", Camera::Bottom}};
  for (const Row& row : rows) {
    actions.add({row.name, tr(row.text), QKeySequence(row.shortcut), tr(row.tip), row.icon, tr(row.button)},
                [&view, camera = row.camera](const QVariantList&) {
                  view.moveCamera(camera);
                  return true;
                });
  }
  actions.add(
      {"view.selection", tr("&Zoom to selection"), QKeySequence("Ctrl+9"),
       tr("Shows the chosen inverse solution, or else the constraints and the tip, from the current direction.")},
      [&view](const QVariantList&) {
        view.fitSelection();
        return true;
      });
  QAction* parallel = actions.add({"view.parallel",
                                   tr("Parallel pro&jection"),
                                   QKeySequence("F4"),
                                   tr("Draws without perspective (orthographic), so that lengths can be compared."),
                                   {},
                                   {},
                                   true},
                                  [&view](const QVariantList& on) {
                                    view.setParallel(on.value(0).toBool());
                                    return true;
                                  });
  QObject::connect(&view, &SceneView::parallelChanged, parallel, &QAction::setChecked);
  actions.add({"view.focus", tr("&Move the hand with the keys"), QKeySequence("F2"),
               tr("Gives the view the keyboard focus, so that the arrow keys move the hand.")},
              [&view](const QVariantList&) {
                view.setFocus(Qt::ShortcutFocusReason);
                return true;
              });
}

void addLayers(Actions& actions, SceneView& view) {
  const auto words = [](const char* text) { return QCoreApplication::translate("layer", text); };
  for (const lesson::Layer& row : lesson::layers()) {
    QAction* action = actions.add({QString("layer.%1").arg(row.name),
                                   words(row.text),
                                   QKeySequence(row.shortcut),
                                   words(row.tip),
                                   {},
                                   row.button == nullptr ? QString() : words(row.button),
                                   true},
                                  [&view, shown = row.shown](const QVariantList& on) {
                                    Layers layers = view.layers();
                                    layers.*shown = on.value(0).toBool();
                                    view.setLayers(layers);
                                    return true;
                                  });
    action->setChecked(view.layers().*row.shown);
  }
}

/// The axis perpendicular to the cut through meshes.
void addSectionAxes(Actions& actions, SceneView& view) {
  struct Row {
    const char *name, *text, *shortcut, *tip, *button;
  };
  const Row rows[] = {{"section.x", QT_TR_NOOP("Cut across x"), "Alt+X",
                       QT_TR_NOOP("Cuts meshes at right angles to x; best seen from the side."), "x"},
                      {"section.y", QT_TR_NOOP("Cut across y"), "Alt+Y",
                       QT_TR_NOOP("Cuts meshes at right angles to y; best seen from the top."), "y"},
                      {"section.z", QT_TR_NOOP("Cut across z"), "Alt+Z",
                       QT_TR_NOOP("Cuts meshes at right angles to z; best seen from the front."), "z"}};
  auto* group = new QActionGroup(&actions);
  for (int axis = 0; axis < 3; ++axis) {
    const Row& row = rows[axis];
    QAction* action =
        actions.add({row.name, tr(row.text), QKeySequence(row.shortcut), tr(row.tip), {}, row.button, true},
                    [&view, axis](const QVariantList&) {
                      Layers layers = view.layers();
                      layers.section_axis = axis;
                      view.setLayers(layers);
                      return true;
                    });
    group->addAction(action);
    action->setChecked(view.layers().section_axis == axis);
  }
}

void addThemes(Actions& actions, ThemeWatcher& theme) {
  struct Row {
    const char *name, *text, *tip;
    ThemeChoice choice;
  };
  const Row rows[] = {
      {"view.theme.system", QT_TR_NOOP("Follow the &system"),
       QT_TR_NOOP("Follows the light or dark theme of the desktop, also while the program runs."), ThemeChoice::System},
      {"view.theme.light", QT_TR_NOOP("&Light"), QT_TR_NOOP("Always light."), ThemeChoice::Light},
      {"view.theme.dark", QT_TR_NOOP("&Dark"), QT_TR_NOOP("Always dark."), ThemeChoice::Dark}};
  auto* group = new QActionGroup(&actions);
  for (const Row& row : rows) {
    QAction* action = actions.add({row.name, tr(row.text), QKeySequence(), tr(row.tip), {}, {}, true},
                                  [&theme, choice = row.choice](const QVariantList&) {
                                    theme.choose(choice);
                                    return true;
                                  });
    group->addAction(action);
    action->setChecked(theme.choice() == row.choice);
  }
}

}  // namespace

void addViewActions(Actions& actions, SceneView& view, ThemeWatcher& theme) {
  addCameras(actions, view);
  addLayers(actions, view);
  addSectionAxes(actions, view);
  addThemes(actions, theme);
}

}  // namespace underact::gui
