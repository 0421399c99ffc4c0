#include "app/gui/kit/style.h"

#include "app/gui/kit/contrast.h"
#include "app/gui/kit/icons.h"

namespace underact::gui {
namespace {

QString between(const QColor& a, const QColor& b, double share_of_a) {
  return mixed(b, a, share_of_a).name();
}

}  // namespace

QString styleSheet(const Theme& theme) {
  const QString ink = theme.ink.name(), ground = theme.background.name();
  const QString quiet = between(theme.ink, theme.background, 0.68);  // contrast above 4.5 on both backgrounds
  const QString line = between(theme.ink, theme.background, 0.16);
  const QString hover = between(theme.ink, theme.background, 0.09);
  const QString red = alarm(theme).name();
  // Amber and vermillion, shifted towards the ink as far as small text needs.
  const QString warm = between(theme.ink, amber(theme), theme.dark ? 0.0 : 0.2);
  const QString limited = between(theme.ink, theme.force_limited, theme.dark ? 0.25 : 0.2);
  const QString red_ground = between(alarm(theme), theme.background, 0.10);
  const QString warm_ground = between(amber(theme), theme.background, 0.14);
  return QString(R"(
QToolBar { border: none; border-bottom: 1px solid %line; padding: 4px 8px; spacing: 4px; }
QToolBar::separator { background: %line; width: 1px; margin: 4px 6px; }
QToolBar QToolButton { padding: 4px 8px; border: 1px solid transparent; border-radius: 4px; }
QToolBar QToolButton:hover { background: %hover; }
QToolBar QToolButton:pressed, QToolBar QToolButton:checked { background: %line; }
QToolBar QToolButton:focus { border-color: %blue; }
QToolBar QToolButton[role="start"], QToolBar QToolButton[role="stop"] { padding: 6px 16px; font-weight: 600; }
QToolBar QToolButton[role="start"] { border: 1px solid %outline; }
QToolBar QToolButton[role="start"]:focus { border-color: %blue; }
QToolBar QToolButton[role="stop"] { border: 2px solid %red; padding: 5px 22px; }
QToolBar QToolButton[role="stop"]:hover { background: %redground; }
QToolBar QToolButton[role="stop"]:focus { background: %redground; border-color: %blue; }
QFrame[role="card"] QToolButton { padding: 3px 8px; border: 1px solid %outline; border-radius: 4px; }
QFrame[role="card"] QToolButton:checked { background: %selected; }
QFrame[role="card"] QToolButton:focus { border-color: %blue; }
QToolBar QToolButton[role="record"]:checked { background: %redground; border-color: %red; font-weight: 600; }
QToolBar QToolButton[role="record"]:checked:focus { border-color: %blue; }
QToolBar#rail { border-bottom: none; border-right: 1px solid %line; padding: 2px; spacing: 0px; }
QToolBar QToolButton[role="rail"] { padding: 1px 4px; }
QToolBar QToolButton[role="rail"]:checked { background: %selected; }
QToolBar QToolButton[role="rail"]::menu-indicator { image: none; width: 0; }
QToolBar QToolButton[role="menu"] { padding-right: 22px; }
QToolBar QToolButton::menu-indicator { subcontrol-origin: padding; subcontrol-position: center right; right: 6px; }
QToolBar QLabel { color: %quiet; padding: 0 4px; }
QDockWidget { titlebar-close-icon: none; font-weight: 600; }
QDockWidget::title { text-align: left; padding: 6px 12px; border-bottom: 1px solid %line; }
QStatusBar { border-top: 1px solid %line; }
QStatusBar::item { border: none; }
QFrame[role="card"] { background: %ground; border: 1px solid %outline; border-radius: 8px; }
QPushButton[role="banner"] { color: %ink; background: %warmground; border: 2px solid %warm; border-radius: 8px; }
QPushButton[role="banner"] { padding: 8px 20px; font-weight: 600; }
QPushButton[role="banner"]:hover { background: %hover; }
QPushButton[role="banner"]:focus { border-color: %blue; }
QFrame[role="card"] QLabel { border: none; background: transparent; }
QLabel[role="quiet"] { color: %quiet; }
QLabel[role="section"] { font-weight: 600; padding-top: 4px; }
QLabel[role="running"] { color: %green; font-weight: 600; }
QLabel[role="alarm-text"] { color: %red; font-weight: 600; }
QLabel[role="limited-text"] { color: %limited; font-weight: 600; }
QLabel[role="amber-text"] { color: %warm; font-weight: 600; }
QLabel[role="alarm"] { color: %ink; background: %redground; border-left: 3px solid %red; padding: 6px 8px; }
QLabel[role="amber"] { color: %ink; background: %warmground; border-left: 3px solid %warm; padding: 6px 8px; }
QDoubleSpinBox[amber="true"] { border: 2px solid %warm; border-radius: 3px; background: %warmground; color: %ink; }
QToolButton[role="choice"] { padding: 3px 8px; border: 1px solid %outline; border-radius: 4px; }
QToolButton[role="choice"]:hover { background: %hover; }
QToolButton[role="choice"]:checked { background: %line; border-color: %blue; }
QToolButton[role="choice"]:focus { background: %hover; border: 2px solid %blue; padding: 2px 7px; }
QToolButton[role="fold"] { border: 1px solid transparent; font-weight: 600; padding: 3px 0; text-align: left; }
QToolButton[role="fold"]:hover { background: %hover; }
QToolButton[role="fold"]:focus { border-color: %blue; }
QListWidget, QTableWidget { background: transparent; }
QListWidget[role="ticks"] { background: %ground; }
QTableWidget::item { color: %ink; }
QTableWidget::item:hover { background: %hover; }
QTableWidget::item:selected { background: %selected; color: %ink; }
QTableWidget QTableCornerButton::section { background: transparent; border: none; }
QTableWidget QHeaderView { background: transparent; }
QTableWidget QHeaderView::section { background: transparent; color: %quiet; border: none; padding: 2px; }
QListWidget::item { padding: 3px 4px; border-radius: 4px; }
QListWidget::item { color: %ink; }
QListWidget::item:disabled { color: %quiet; }
QListWidget::item:hover { background: %hover; }
QListWidget::item:selected { background: %selected; color: %ink; }
QListWidget::item:selected:focus { background: %selected; }
)")
      .replace("%redground", red_ground)
      .replace("%warmground", warm_ground)
      .replace("%selected", between(theme.constraint, theme.background, theme.dark ? 0.45 : 0.22))
      .replace("%ground", ground)
      .replace("%limited", limited)
      .replace("%outline", outlineColour(paletteOf(theme)).name())
      .replace("%line", line)
      .replace("%hover", hover)
      .replace("%quiet", quiet)
      .replace("%ink", ink)
      .replace("%red", red)
      .replace("%warm", warm)
      .replace("%blue", focusColour(paletteOf(theme)).name())
      .replace("%green", theme.dark ? theme.target.lighter(130).name() : theme.target.darker(130).name());
}

}  // namespace underact::gui
