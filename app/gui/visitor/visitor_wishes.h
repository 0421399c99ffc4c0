#pragma once
#include <QStringList>

namespace underact::gui {

/// What the demonstrator wants visitors to have; remembered.
struct VisitorWishes {
  QStringList scenes;      // files, in the order of the list
  int dwell_s = 90;        // that each one is shown
  int force_percent = 50;  // of the continuous force of the arm
};

inline constexpr int kShortestDwell_s = 10, kLongestDwell_s = 3600;
inline constexpr int kLeastForce_percent = 10, kMostForce_percent = 100;

/// Scenes that are gone are left out; where none is left, some of those that come with the program.
VisitorWishes readVisitorWishes();
void writeVisitorWishes(const VisitorWishes& wishes);

}  // namespace underact::gui
