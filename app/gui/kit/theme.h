#pragma once
#include <QColor>
#include <QDBusVariant>
#include <QObject>
#include <QPalette>

namespace underact::gui {

/// Colours by meaning, the same in view, plots and panels (look.md; Okabe and Ito's palette, told apart by colour-blind
/// people).
struct Theme {
  bool dark = false;
  bool high_contrast = false;  // for a projector in a bright room
  QColor background;           // of the view: #F7F7F5 or #1E1F22, flat
  QColor ink;                  // the stylus, the real arm, text over the view: near-black or near-white
  QColor quiet;                // the workspace box, ticks, grid lines
  QColor constraint{0x00, 0x72, 0xB2};
  QColor target{0x00, 0x9E, 0x73};
  QColor orientation{0x56, 0xB4, 0xE9};  // of the stylus: alpha, the orientation-nearest point
  QColor position{0xCC, 0x79, 0xA7};     // of the tip: beta, the position-nearest point
  QColor force{0xE6, 0x9F, 0x00};
  QColor force_limited{0xD5, 0x5E, 0x00};
  QColor virtual_robot{0xCC, 0x79, 0xA7};  // ghosts of the arm among them
  QColor motion{0x56, 0xB4, 0xE9};         // how far the tip can move
  QColor x_axis, y_axis, z_axis;           // muted red, green, blue

  static Theme light();
  static Theme dark_theme();
  /// Black on white or white on black; colours keep their meaning, with a contrast of 3:1 or more.
  static Theme contrasting(bool dark);
  bool operator==(const Theme&) const = default;
};

/// Blends a and b: share 0 gives a, 1 gives b.
QColor mixed(const QColor& a, const QColor& b, double share);
/// The colour with that opacity: 1 hides what is behind it.
QColor faint(QColor colour, double share);

/// A whole palette for the theme, used where the system's does not fit.
QPalette paletteOf(const Theme& theme);

enum class ThemeChoice { System, Light, Dark };

/// Follows the system's light or dark, also while running: the desktop portal over D-Bus (org.freedesktop.appearance
/// color-scheme), else the lightness of the palette's window colour. One per program. The portal is asked without
/// blocking: until it answers, or without a bus, the palette decides.
class ThemeWatcher : public QObject {
  Q_OBJECT
 public:
  explicit ThemeWatcher(QObject* parent = nullptr);
  void choose(ThemeChoice choice);  // System follows; Light and Dark hold; also gives QApplication the palette
  ThemeChoice choice() const { return choice_; }
  /// Uses high-contrast colours; the choice of light or dark stays.
  void setHighContrast(bool on);
  Theme theme() const;
 signals:
  void changed(const underact::gui::Theme& theme);  // once per actual change

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private slots:
  void portalSettingChanged(const QString& group, const QString& key, const QDBusVariant& value);

 private:
  void askPortal();
  void portalSays(uint scheme);
  void apply();
  ThemeChoice choice_ = ThemeChoice::System;
  uint portal_scheme_ = 0;  // 0 no preference (or no portal), 1 dark, 2 light
  bool system_dark_ = false;
  bool dark_ = false;         // as last emitted
  bool own_palette_ = false;  // QApplication has one of ours
  bool applying_ = false;
  bool contrast_ = false, announced_contrast_ = false;
};

/// Gives it the theme, now and whenever another one comes.
template <class Drawn>
Drawn* inTheme(const ThemeWatcher& theme, Drawn* drawn) {
  QObject::connect(&theme, &ThemeWatcher::changed, drawn, &Drawn::setTheme);
  drawn->setTheme(theme.theme());
  return drawn;
}

/// The colour, shifted towards the ink as far as small text over the view needs: 4.5:1 (WCAG 2.1, 1.4.3).
QColor readable(const QColor& colour, const Theme& theme);

/// The focus ring: the selection colour, paler on a dark background, where the ring may lie on that colour.
QColor focusColour(const QPalette& palette);

}  // namespace underact::gui
