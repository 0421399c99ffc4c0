#pragma once
#include <QStringList>

namespace underact::gui {

/// The demonstrator's choices for visitor mode; saved in the settings.
struct VisitorSettings {
  QStringList scenes;      // file paths, in the order of the list
  int dwell_s = 90;        // how long each one is shown
  int force_percent = 50;  // of the continuous force of the arm
};

inline constexpr int kShortestDwell_s = 10, kLongestDwell_s = 3600;
inline constexpr int kMinForce_percent = 10, kMaxForce_percent = 100;

/// Missing scenes are left out; if none remains, some of those that come with the program are used.
VisitorSettings readVisitorSettings();
void writeVisitorSettings(const VisitorSettings& visitor_settings);

}  // namespace underact::gui
