#include "app/gui/view/view_actions.h"

#include <QAction>
#include <QActionGroup>

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
      {"view.fit", QT_TR_NOOP("&Fit"), "Ctrl+0", QT_TR_NOOP("Shows all of the scene, from the same direction."), "fit",
       QT_TR_NOOP("Fit"), Camera::Fit},
      {"view.front", QT_TR_NOOP("F&ront"), "Ctrl+1", QT_TR_NOOP("Looks from where the hand is, along −z."), "front",
       QT_TR_NOOP("Front"), Camera::Front},
      {"view.top", QT_TR_NOOP("&Top"), "Ctrl+2", QT_TR_NOOP("Looks down, along −y."), "top", QT_TR_NOOP("Top"),
       Camera::Top},
      {"view.side", QT_TR_NOOP("&Side"), "Ctrl+3", QT_TR_NOOP("Looks from the right, along −x."), "side",
       QT_TR_NOOP("Side"), Camera::Right},
      {"view.isometric", QT_TR_NOOP("&Isometric"), "Ctrl+4", QT_TR_NOOP("Looks from above, in front and the right."),
       "isometric", QT_TR_NOOP("Isometric"), Camera::Isometric},
      {"view.left", QT_TR_NOOP("&Left"), "Ctrl+5", QT_TR_NOOP("Looks from the left, along x."), "", "", Camera::Left},
      {"view.back", QT_TR_NOOP("&Back"), "Ctrl+6", QT_TR_NOOP("Looks from behind the arm, along z."), "", "",
       Camera::Back},
      {"view.bottom", QT_TR_NOOP("B&ottom"), "Ctrl+7", QT_TR_NOOP("Looks up, along y."), "", "", Camera::Bottom}};
  for (const Row& row : rows) {
    actions.add({row.name, tr(row.text), QKeySequence(row.shortcut), tr(row.tip), row.icon, tr(row.button)},
                [&view, camera = row.camera](const QVariantList&) {
                  view.look(camera);
                  return true;
                });
  }
  actions.add({"view.focus", tr("&Move the hand with the keys"), QKeySequence("F2"),
               tr("Puts the focus into the view: the arrow keys then move the hand.")},
              [&view](const QVariantList&) {
                view.setFocus(Qt::ShortcutFocusReason);
                return true;
              });
}

void addLayers(Actions& actions, SceneView& view) {
  struct Row {
    const char *name, *text, *shortcut, *tip;
    bool Layers::*layer;
    const char* button = "";
  };
  const Row rows[] = {
      {"layer.workspace", QT_TR_NOOP("&Workspace box"), "Alt+1",
       QT_TR_NOOP("The box the arm can reach, with ticks every 20 mm."), &Layers::workspace},
      {"layer.triads", QT_TR_NOOP("&Axes of W and B"), "Alt+2",
       QT_TR_NOOP("The axes of the workspace and of the arm's base."), &Layers::triads},
      {"layer.arm", QT_TR_NOOP("A&rm"), "Alt+3", QT_TR_NOOP("The arm's links."), &Layers::arm},
      {"layer.target", QT_TR_NOOP("&Target and error"), "Alt+4",
       QT_TR_NOOP("The point the stylus is drawn to, and the line to it."), &Layers::target},
      {"layer.force", QT_TR_NOOP("&Force"), "Alt+5", QT_TR_NOOP("The arrow of the force sent."), &Layers::force},
      {"layer.influence", QT_TR_NOOP("&Influence"), "Ctrl+Alt+I",
       QT_TR_NOOP("Where the stylus points (o), the point nearest to its tip (p), and the target's arc between them."),
       &Layers::influence},
      {"layer.robot", QT_TR_NOOP("&Virtual robot"), "Ctrl+Alt+R",
       QT_TR_NOOP("The robots that exist only in software, where their joints are, and which ways their tips can go."),
       &Layers::robot},
      {"layer.path", QT_TR_NOOP("Recorded &path"), "Alt+P",
       QT_TR_NOOP("Where the tip went in the session that is replayed; the more force, the more vermillion."),
       &Layers::path},
      {"layer.desk", QT_TR_NOOP("&Desk"), "Ctrl+Alt+Shift+K",
       QT_TR_NOOP("The marks on the desk by which the arm was registered."), &Layers::desk},
      {"layer.from_desk", QT_TR_NOOP("As se&en from the desk"), "Ctrl+Alt+Shift+V",
       QT_TR_NOOP(
           "Left, right and up are those of the desk, however a registered arm is turned; off: those of the arm."),
       &Layers::from_desk},
      {"layer.link_frames", QT_TR_NOOP("&Link frames"), "Alt+6",
       QT_TR_NOOP(
           "The frames 1 to 6 of the DH table along the arm; each number stands at the end of a joint's axis z."),
       &Layers::link_frames},
      {"layer.ghosts", QT_TR_NOOP("Inver&se solutions"), "Alt+7",
       QT_TR_NOOP("All ways the arm can reach the stylus, as ghosts; dashed: outside the joint limits."),
       &Layers::ghosts},
      {"layer.motion_ellipsoid", QT_TR_NOOP("&Motion ellipsoid (v)"), "Alt+8",
       QT_TR_NOOP("Where the tip gets to by a joint turn of 0.25 rad in all (manipulability ellipsoid)."),
       &Layers::motion_ellipsoid},
      {"layer.force_ellipsoid", QT_TR_NOOP("F&orce ellipsoid (f)"), "Alt+9",
       QT_TR_NOOP("The forces of 0.05 N m of joint torque in all, drawn to the scale of the force arrow."),
       &Layers::force_ellipsoid},
      {"layer.wires", QT_TR_NOOP("Mes&h: triangles"), "Alt+T",
       QT_TR_NOOP("The edges of all triangles of a mesh, as it is drawn."), &Layers::wires},
      {"layer.section", QT_TR_NOOP("Mesh: &cut open"), "Alt+C",
       QT_TR_NOOP("Cuts meshes open across an axis; the side nearer to the eye is hidden. What is felt stays whole."),
       &Layers::section},
      {"layer.section_follows", QT_TR_NOOP("C&ut follows the stylus"), "Alt+K",
       QT_TR_NOOP("The cut goes through the stylus's tip; off, it stays where it is."), &Layers::section_follows,
       QT_TR_NOOP("Follow")}};
  for (const Row& row : rows) {
    QAction* action = actions.add({row.name,
                                   tr(row.text),
                                   QKeySequence(row.shortcut),
                                   tr(row.tip),
                                   {},
                                   row.button[0] == '\0' ? QString() : tr(row.button),
                                   true},
                                  [&view, layer = row.layer](const QVariantList& on) {
                                    Layers layers = view.layers();
                                    layers.*layer = on.value(0).toBool();
                                    view.setLayers(layers);
                                    return true;
                                  });
    action->setChecked(view.layers().*row.layer);
  }
}

/// Which axis the cut through meshes is across.
void addSectionAxes(Actions& actions, SceneView& view) {
  struct Row {
    const char *name, *text, *shortcut, *tip, *button;
  };
  const Row rows[] = {{"section.x", QT_TR_NOOP("Cut across x"), "Alt+X",
                       QT_TR_NOOP("The cut stands across x: it is seen from the side."), "x"},
                      {"section.y", QT_TR_NOOP("Cut across y"), "Alt+Y",
                       QT_TR_NOOP("The cut stands across y: it is seen from the top."), "y"},
                      {"section.z", QT_TR_NOOP("Cut across z"), "Alt+Z",
                       QT_TR_NOOP("The cut stands across z: it is seen from the front."), "z"}};
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
    const char *name, *text, *shortcut, *tip;
    ThemeChoice choice;
  };
  const Row rows[] = {
      {"view.theme.system", QT_TR_NOOP("As the &system"), "Ctrl+Alt+S",
       QT_TR_NOOP("Light or dark as the desktop is, also while running."), ThemeChoice::System},
      {"view.theme.light", QT_TR_NOOP("&Light"), "Ctrl+Alt+L", QT_TR_NOOP("Always light."), ThemeChoice::Light},
      {"view.theme.dark", QT_TR_NOOP("&Dark"), "Ctrl+Alt+D", QT_TR_NOOP("Always dark."), ThemeChoice::Dark}};
  auto* group = new QActionGroup(&actions);
  for (const Row& row : rows) {
    QAction* action = actions.add({row.name, tr(row.text), QKeySequence(row.shortcut), tr(row.tip), {}, {}, true},
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
