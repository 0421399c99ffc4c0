#include "app/gui/kit/theme.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QEvent>
#include <QFileInfo>
#include <QScopedValueRollback>
#include <QStyle>
#include <QTimer>

#include "app/gui/kit/contrast.h"

namespace underact::gui {
namespace {

const QString kService = QStringLiteral("org.freedesktop.portal.Desktop");
const QString kPortalPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString kInterface = QStringLiteral("org.freedesktop.portal.Settings");
const QString kGroup = QStringLiteral("org.freedesktop.appearance");
const QString kSchemeKey = QStringLiteral("color-scheme");

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

/// Whether there is a bus: connecting to a missing one may try to start it, and wait.
bool hasSessionBus() {
  if (!qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS")) return true;
  const QString folder = qEnvironmentVariable("XDG_RUNTIME_DIR");
  return !folder.isEmpty() && QFileInfo::exists(folder + QStringLiteral("/bus"));
}

uint schemeIn(QVariant value) {  // Read wraps the number twice, SettingChanged once
  while (value.userType() == qMetaTypeId<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
  return value.toUInt();
}

}  // namespace

Theme Theme::light() {
  Theme theme;
  theme.background = QColor(0xF7, 0xF7, 0xF5);
  theme.ink = QColor(0x1B, 0x1C, 0x1E);
  theme.quiet = QColor(0xB4, 0xB5, 0xB2);
  // Hues of the dark theme, dark enough for 3:1 against the light background and that of the panels (WCAG 2.1).
  theme.target = QColor(0x00, 0x9B, 0x71);
  theme.orientation = QColor(0x00, 0x92, 0xCC);
  theme.position = QColor(0xBD, 0x70, 0x9B);
  theme.force = QColor(0xB6, 0x7E, 0x00);
  theme.virtual_robot = theme.position;
  theme.motion = theme.orientation;
  theme.x_axis = QColor(0xB8, 0x4A, 0x44);
  theme.y_axis = QColor(0x4B, 0x85, 0x42);
  theme.z_axis = QColor(0x42, 0x68, 0xB0);
  return theme;
}

Theme Theme::dark_theme() {
  Theme theme;
  theme.dark = true;
  theme.background = QColor(0x1E, 0x1F, 0x22);
  theme.ink = QColor(0xF2, 0xF2, 0xEE);
  theme.quiet = QColor(0x5C, 0x5F, 0x66);
  theme.constraint = QColor(0x00, 0x79, 0xBD);  // 3:1 on the panels' background, and white text on it is still readable
  theme.x_axis = QColor(0xDB, 0x83, 0x7B);
  theme.y_axis = QColor(0x8C, 0xC0, 0x80);
  theme.z_axis = QColor(0x8C, 0xAB, 0xE6);
  return theme;
}

Theme Theme::contrasting(bool dark) {
  Theme theme = dark ? dark_theme() : light();
  theme.high_contrast = true;
  theme.background = dark ? QColor(0x00, 0x00, 0x00) : QColor(0xFF, 0xFF, 0xFF);
  theme.ink = dark ? QColor(0xFF, 0xFF, 0xFF) : QColor(0x00, 0x00, 0x00);
  theme.quiet = dark ? QColor(0x9A, 0x9A, 0x9A) : QColor(0x6B, 0x6B, 0x6B);
  theme.constraint = dark ? QColor(0x4D, 0xB2, 0xF0) : QColor(0x00, 0x5E, 0x94);
  theme.target = dark ? QColor(0x2F, 0xD3, 0xA2) : QColor(0x00, 0x70, 0x4F);
  theme.orientation = dark ? QColor(0x8F, 0xD0, 0xF7) : QColor(0x1F, 0x7A, 0xB5);
  theme.position = dark ? QColor(0xE8, 0x9C, 0xC5) : QColor(0xA0, 0x45, 0x7B);
  theme.force = dark ? QColor(0xFF, 0xB0, 0x00) : QColor(0xA6, 0x5E, 0x00);
  theme.force_limited = dark ? QColor(0xFF, 0x7A, 0x33) : QColor(0xB8, 0x3A, 0x00);
  theme.virtual_robot = theme.position;
  theme.motion = theme.orientation;
  return theme;
}

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto part = [share](float from, float to) { return from + static_cast<float>(share) * (to - from); };
  return QColor::fromRgbF(part(a.redF(), b.redF()), part(a.greenF(), b.greenF()), part(a.blueF(), b.blueF()));
}

QColor faint(QColor colour, double share) {
  colour.setAlphaF(static_cast<float>(share));
  return colour;
}

QPalette paletteOf(const Theme& theme) {
  const QColor default_value = theme.dark ? QColor(0x2A, 0x2B, 0x2F) : QColor(0xEF, 0xEF, 0xEC);
  const QColor window = theme.high_contrast ? theme.background : default_value;
  const QColor base = theme.dark ? theme.background : QColor(0xFF, 0xFF, 0xFF);
  const QColor button = theme.dark ? QColor(0x36, 0x38, 0x3D) : QColor(0xF7, 0xF7, 0xF5);
  const QColor text = theme.ink;
  const QColor disabled = mixed(window, text, 0.45);
  QPalette palette(button, window);  // the shades of frames derive from it
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::All, role, text);
    palette.setColor(QPalette::Disabled, role, disabled);
  }
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, mixed(base, window, 0.6));
  palette.setColor(QPalette::Button, button);
  palette.setColor(QPalette::BrightText, QColor(Qt::white));
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::PlaceholderText, mixed(base, text, 0.65));
  palette.setColor(QPalette::Highlight, theme.constraint);
  const bool is_pale = theme.dark && theme.high_contrast;  // the selection colour
  palette.setColor(QPalette::HighlightedText, is_pale ? theme.background : QColor(Qt::white));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, mixed(window, text, 0.25));
  palette.setColor(QPalette::Link, theme.dark ? QColor(0x56, 0xB4, 0xE9) : theme.constraint);
  palette.setColor(QPalette::LinkVisited, theme.dark ? QColor(0xCC, 0x79, 0xA7) : QColor(0x8A, 0x4A, 0x70));
  return palette;
}

ThemeWatcher::ThemeWatcher(QObject* parent) : QObject(parent) {
  system_dark_ = isDark(QApplication::palette());
  dark_ = system_dark_;
  qApp->installEventFilter(this);
  QTimer::singleShot(0, this, &ThemeWatcher::askPortal);
}

void ThemeWatcher::askPortal() {
  if (!hasSessionBus()) return;
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return;
  bus.connect(kService, kPortalPath, kInterface, QStringLiteral("SettingChanged"), this,
              SLOT(portalSettingChanged(QString, QString, QDBusVariant)));
  QDBusMessage question = QDBusMessage::createMethodCall(kService, kPortalPath, kInterface, QStringLiteral("Read"));
  question << kGroup << kSchemeKey;
  auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
  connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
    const QDBusPendingReply<QDBusVariant> reply = *answer;
    if (reply.isValid()) portalSays(schemeIn(reply.value().variant()));
    answer->deleteLater();
  });
}

void ThemeWatcher::portalSettingChanged(const QString& group, const QString& key, const QDBusVariant& value) {
  if (group == kGroup && key == kSchemeKey) portalSays(schemeIn(value.variant()));
}

void ThemeWatcher::portalSays(uint scheme) {
  portal_scheme_ = scheme <= 2 ? scheme : 0;
  apply();
}

void ThemeWatcher::choose(ThemeChoice choice) {
  choice_ = choice;
  apply();
}

void ThemeWatcher::setHighContrast(bool on) {
  contrast_ = on;
  apply();
}

Theme ThemeWatcher::theme() const {
  if (contrast_) return Theme::contrasting(dark_);
  return dark_ ? Theme::dark_theme() : Theme::light();
}

void ThemeWatcher::apply() {
  const QScopedValueRollback<bool> applying(applying_, true);
  if (own_palette_ && choice_ == ThemeChoice::System) {
    QApplication::setPalette(QPalette());  // back to the system's
    own_palette_ = false;
  }
  if (!own_palette_) system_dark_ = isDark(QApplication::palette());
  const bool system_wants_dark = portal_scheme_ == 0 ? system_dark_ : portal_scheme_ == 1;
  const bool dark = choice_ == ThemeChoice::System ? system_wants_dark : choice_ == ThemeChoice::Dark;
  const bool is_told = dark == dark_ && contrast_ == announced_contrast_;
  dark_ = dark;
  announced_contrast_ = contrast_;
  if (choice_ != ThemeChoice::System || dark != system_dark_ || contrast_) {
    // Styles that draw with native elements support only one lightness.
    const QString style = QApplication::style()->name();
    if (style.startsWith(QLatin1String("windows"), Qt::CaseInsensitive))
      QApplication::setStyle(QStringLiteral("Fusion"));
    QApplication::setPalette(paletteOf(theme()));
    own_palette_ = true;
  }
  if (!is_told) emit changed(theme());
}

bool ThemeWatcher::eventFilter(QObject* object, QEvent* event) {
  const bool from_system = object == qApp && event->type() == QEvent::ApplicationPaletteChange && !applying_;
  if (from_system && !own_palette_) QTimer::singleShot(0, this, [this] { apply(); });
  return QObject::eventFilter(object, event);
}

QColor readable(const QColor& colour, const Theme& theme) {
  constexpr double kWords = 4.5;
  constexpr int kSteps = 20;
  for (int step = 0; step < kSteps; ++step) {
    const QColor words = mixed(colour, theme.ink, static_cast<double>(step) / kSteps);
    if (contrastOf(words, theme.background) >= kWords) return words;
  }
  return theme.ink;
}

QColor focusColour(const QPalette& palette) {
  const bool is_dark = luminanceOf(palette.color(QPalette::Window)) < luminanceOf(palette.color(QPalette::WindowText));
  const QColor chosen = palette.color(QPalette::Highlight);
  return is_dark ? chosen.lighter(150) : chosen;
}

}  // namespace underact::gui
