#include "app/gui/guide/help_pages.h"

#include <QWidget>
#include <array>

namespace underact::gui {

std::span<const HelpPage> helpPages() {
  static constexpr std::array kPages{
      HelpPage{"window", "window"},
      HelpPage{"view", "window#the-view"},
      HelpPage{"view.kinematics", "kinematics#in-the-window"},
      HelpPage{"toolbar", "window#starting-and-stopping"},
      HelpPage{"button", "window#starting-and-stopping"},
      HelpPage{"button.session.record", "sessions"},
      HelpPage{"button.help.guide", "window#this-guide"},
      HelpPage{"status", "window#the-status-line"},
      HelpPage{"section", "meshes"},
      HelpPage{"load", "meshes"},
      HelpPage{"compare", "classes#two-scenes-on-one-motion"},
      HelpPage{"panel.scenes", "window#scenes"},
      HelpPage{"panel.feel", "window#feel"},
      HelpPage{"panel.gains", "window#feel"},
      HelpPage{"panel.influence", "scenes#influence"},
      HelpPage{"panel.rate", "velocity"},
      HelpPage{"panel.rate.passivity", "energy"},
      HelpPage{"panel.surface", "meshes"},
      HelpPage{"panel.surface.friction", "scenes#friction"},
      HelpPage{"panel.guide", "curves"},
      HelpPage{"panel.shape", "window#shape"},
      HelpPage{"panel.arm", "window#arm"},
      HelpPage{"panel.plots", "window#plots"},
      HelpPage{"panel.kinematics", "kinematics#in-the-window"},
      HelpPage{"panel.kinematics.joint", "kinematics#moving-the-joints"},
      HelpPage{"panel.kinematics.singularity", "kinematics#distance-to-singularities"},
      HelpPage{"panel.kinematics.solutions", "kinematics#inverse-solutions"},
      HelpPage{"panel.kinematics.dh", "kinematics#dh-table-and-angle-conventions"},
      HelpPage{"panel.kinematics.jacobian", "kinematics#jacobian-and-ellipsoids"},
      HelpPage{"panel.dh", "explorers#dh-table"},
      HelpPage{"panel.transform", "explorers#transforms"},
      HelpPage{"panel.robot", "robots"},
      HelpPage{"panel.calibration", "calibration"},
      HelpPage{"panel.devices", "devices#choosing-an-arm"},
      HelpPage{"panel.second", "devices#two-arms"},
      HelpPage{"panel.hands", "hands"},
      HelpPage{"panel.servo", "servo"},
      HelpPage{"panel.servo.scheduling", "real_time"},
      HelpPage{"panel.step", "step_response"},
      HelpPage{"panel.lab", "lab"},
      HelpPage{"panel.lessons", "lessons"},
      HelpPage{"panel.sessions", "sessions"},
      HelpPage{"panel.session", "replay"},
      HelpPage{"panel.replay", "replay"},
      HelpPage{"ghost", "following"},
      HelpPage{"identify", "identify"},
      HelpPage{"registration", "registration"},
      HelpPage{"guide", "window#this-guide"},
      HelpPage{"welcome", "first_minute"},
      HelpPage{"tour", "first_minute"},
      HelpPage{"demonstrator", "visitor"},
      HelpPage{"dialog", "window"},
      HelpPage{"dialog.about", "safety#what-was-never-tried"},
      HelpPage{"dialog.add_curve", "curves"},
      HelpPage{"dialog.add_mesh", "meshes"},
      HelpPage{"dialog.address", "window#this-guide"},
      HelpPage{"dialog.arm_problems", "devices"},
      HelpPage{"dialog.check", "real_time"},
      HelpPage{"dialog.compare_scene", "classes#two-scenes-on-one-motion"},
      HelpPage{"dialog.curve", "curves"},
      HelpPage{"dialog.curve_problems", "curves"},
      HelpPage{"dialog.delete_session", "sessions"},
      HelpPage{"dialog.fault", "faults"},
      HelpPage{"dialog.figures", "thesis_figures"},
      HelpPage{"dialog.fix", "devices"},
      HelpPage{"dialog.follow", "following"},
      HelpPage{"dialog.guide_problems", "install"},
      HelpPage{"dialog.help", "window#mouse-and-keys"},
      HelpPage{"dialog.live", "sessions"},
      HelpPage{"dialog.mesh", "meshes"},
      HelpPage{"dialog.mesh_problems", "meshes"},
      HelpPage{"dialog.language", "languages"},
      HelpPage{"dialog.newer_settings", "install"},
      HelpPage{"dialog.no_visitors", "visitor"},
      HelpPage{"dialog.not_saved", "window#feel"},
      HelpPage{"dialog.open", "scenes"},
      HelpPage{"dialog.open_lesson", "lessons"},
      HelpPage{"dialog.problems", "scenes"},
      HelpPage{"dialog.registration_sheet", "registration"},
      HelpPage{"dialog.remove_session", "sessions#find-and-use"},
      HelpPage{"dialog.replay_files", "replay"},
      HelpPage{"dialog.save", "window#feel"},
      HelpPage{"dialog.save_calibration", "calibration"},
      HelpPage{"dialog.save_lesson_report", "lessons#the-report"},
      HelpPage{"dialog.save_session", "sessions"},
      HelpPage{"dialog.second_scene", "devices#two-arms"},
      HelpPage{"dialog.session", "sessions"},
      HelpPage{"dialog.session_folder", "sessions"},
      HelpPage{"dialog.session_problems", "replay"},
      HelpPage{"dialog.unsaved", "window#feel"},
      HelpPage{"dialog.words", "sessions"},
  };
  return kPages;
}

namespace {

/// The row with the longest part that the name is, or goes on from with a dot; null: none.
const HelpPage* rowOf(const QString& name) {
  const HelpPage* best = nullptr;
  qsizetype length = 0;
  for (const HelpPage& row : helpPages()) {
    const QString part = QString::fromLatin1(row.part);
    if (part.size() <= length || (name != part && !name.startsWith(part + '.'))) continue;
    best = &row;
    length = part.size();
  }
  return best;
}

}  // namespace

QString helpPlaceOf(const QWidget* widget) {
  for (const QWidget* part = widget; part != nullptr; part = part->parentWidget()) {
    if (const HelpPage* row = rowOf(part->objectName())) return QString::fromLatin1(row->place);
  }
  return "start";
}

}  // namespace underact::gui
