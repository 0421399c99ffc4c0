#pragma once
#include <QByteArray>
#include <QHash>
#include <QStringList>

#include "app/gui/kit/theme.h"
#include "app/gui/model/layers.h"

namespace underact::gui {

/// The layers of a first start: the box with its numbers and the frames W and B are not shown until asked for.
inline Layers quietLayers() {
  Layers layers;
  layers.workspace = layers.triads = false;
  return layers;
}

/// What the window saves between runs.
struct Settings {
  bool are_newer = false;  // the stored settings are of a newer version: they are neither read nor changed
  QByteArray geometry;
  QString purpose;                     // what the window is used for; empty: not chosen yet
  QHash<QString, QByteArray> layouts;  // of the tool bar and docks, by purpose
  ThemeChoice theme = ThemeChoice::System;
  Layers layers = quietLayers();
  QStringList recent;
  QString last_scene;
  int plot_axis = 0;
  bool energy_plot = true;
  bool hold_to_run = false;
  bool keeps_holding = false;  // the simulated hand, when the mouse is released
  QString arm_model;           // model of the simulated arm, as in its file; empty: the vendor's figures
  QString device;              // the arm that was in use; empty: the simulated one
  int servo_rate_hz = 1000;    // chosen last; the command line overrides it
  QString guide_page;          // place in the guide read last: "PAGE#heading"; empty: none
  int guide_zoom = 100;        // percent
  bool has_pushed = false;     // the welcome card has been used, for example by pushing
  bool projector = false;      // the layout for a projector is on
  bool left_handed = false;    // scenes are mirrored
};

/// The version of the stored format. A new key that may be missing does not need a new version.
constexpr int kSettingsVersion = 1;

/// Reads the user's settings; keys missing from those of an older version keep the defaults above.
Settings readSettings();
/// Does nothing where are_newer.
void writeSettings(const Settings& settings);

}  // namespace underact::gui
