#pragma once
#include <QByteArray>
#include <QStringList>

#include "app/gui/kit/theme.h"
#include "app/gui/model/layers.h"

namespace underact::gui {

/// What the window remembers between two runs.
struct Settings {
  bool are_newer = false;  // what is stored is of a newer Underact: nothing of it is read, and it stays as it is
  QByteArray geometry;
  QByteArray layout;  // of tool bar and docks
  ThemeChoice theme = ThemeChoice::System;
  Layers layers;
  QStringList recent;
  QString last_scene;
  int plot_axis = 0;
  bool energy_plot = true;
  bool hold_to_run = false;
  QString arm_model;         // that is simulated, as its file says it; empty: the vendor's figures
  QString device;            // the arm that was in use; empty: the simulated one
  int servo_rate_hz = 1000;  // that was chosen last; the command line's goes first
  QString guide_page;        // where the guide was read last: "PAGE#heading"; empty: never
  int guide_zoom = 100;      // percent
  bool has_pushed = false;   // the welcome has done its work: a hand has pushed, say
  bool projector = false;    // the layout for a projector is on
  bool left_handed = false;  // scenes are mirrored
};

/// The layout of what is stored. A key that is new, and may be missing, is no other layout.
constexpr int kSettingsVersion = 1;

/// From the user's settings; what is missing there, in those of an older Underact, is as above.
Settings readSettings();
/// Does nothing where are_newer.
void writeSettings(const Settings& settings);

}  // namespace underact::gui
