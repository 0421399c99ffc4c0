#include "app/gui/panels.h"

#include <QCoreApplication>
#include <array>

#include "app/gui/arm_panel.h"
#include "app/gui/calibration/calibration_panel.h"
#include "app/gui/devices/devices_panel.h"
#include "app/gui/explore/dh_panel.h"
#include "app/gui/explore/transform_panel.h"
#include "app/gui/feel_panel.h"
#include "app/gui/hands/hands_panel.h"
#include "app/gui/kinematics_panel.h"
#include "app/gui/lab/lab_panel.h"
#include "app/gui/lessons/lessons_panel.h"
#include "app/gui/plots_panel.h"
#include "app/gui/replay/session_panel.h"
#include "app/gui/robot_panel.h"
#include "app/gui/scenes_panel.h"
#include "app/gui/second/second_panel.h"
#include "app/gui/servo_panel.h"
#include "app/gui/sessions/sessions_panel.h"
#include "app/gui/shape_panel.h"
#include "app/gui/step/step_panel.h"

namespace underact::gui {
namespace {

template <class Kind>
Panel* makePanel(const PanelParts& parts, QWidget* parent) {
  return new Kind(parts, parent);
}

}  // namespace

std::span<const PanelRow> panels() {
  static const std::array<PanelRow, 19> kRows{{
      {"scenes", QT_TRANSLATE_NOOP("panel", "Scenes"), Qt::LeftDockWidgetArea, "Ctrl+Alt+1",
       QT_TRANSLATE_NOOP("panel", "The scenes that come with the program, and your own."), makePanel<ScenesPanel>},
      {"feel", QT_TRANSLATE_NOOP("panel", "Feel"), Qt::RightDockWidgetArea, "Ctrl+Alt+2",
       QT_TRANSLATE_NOOP("panel", "How hard the constraint pulls, axis by axis."), makePanel<FeelPanel>},
      {"shape", QT_TRANSLATE_NOOP("panel", "Shape"), Qt::RightDockWidgetArea, "Ctrl+Alt+3",
       QT_TRANSLATE_NOOP("panel", "What the stylus is held to, in numbers."), makePanel<ShapePanel>},
      {"arm", QT_TRANSLATE_NOOP("panel", "Arm"), Qt::RightDockWidgetArea, "Ctrl+Alt+4",
       QT_TRANSLATE_NOOP("panel", "Where the joints and the tip of the arm are."), makePanel<ArmPanel>},
      {"plots", QT_TRANSLATE_NOOP("panel", "Plots"), Qt::BottomDockWidgetArea, "Ctrl+Alt+5",
       QT_TRANSLATE_NOOP("panel", "Error and force over the last 10 s, and one axis' displacement against its force."),
       makePanel<PlotsPanel>},
      {"kinematics", QT_TRANSLATE_NOOP("panel", "Kinematics"), Qt::LeftDockWidgetArea, "Ctrl+Alt+6",
       QT_TRANSLATE_NOOP("panel", "Joints, DH table, inverse solutions, Jacobian and singularities."),
       makePanel<KinematicsPanel>, "scenes"},
      {"dh", QT_TRANSLATE_NOOP("panel", "DH table"), Qt::LeftDockWidgetArea, "Ctrl+Alt+Shift+E",
       QT_TRANSLATE_NOOP("panel", "A DH table to be changed, drawn with the arm's joints beside the arm."),
       makePanel<DhPanel>, "scenes"},
      {"transform", QT_TRANSLATE_NOOP("panel", "Transforms"), Qt::LeftDockWidgetArea, "Ctrl+Alt+Shift+O",
       QT_TRANSLATE_NOOP("panel", "Turns and shifts put together, in both orders side by side."),
       makePanel<TransformPanel>, "scenes"},
      {"robot", QT_TRANSLATE_NOOP("panel", "Robot"), Qt::LeftDockWidgetArea, "Ctrl+Alt+7",
       QT_TRANSLATE_NOOP("panel",
                         "The robot that exists only in software: joints, springs, turning stiffness, solver."),
       makePanel<RobotPanel>, "scenes"},
      {"calibration", QT_TRANSLATE_NOOP("panel", "Calibration"), Qt::LeftDockWidgetArea, "Ctrl+Alt+8",
       QT_TRANSLATE_NOOP("panel", "How small a difference of stiffness a hand can tell, with two beams."),
       makePanel<CalibrationPanel>, "scenes"},
      {"devices", QT_TRANSLATE_NOOP("panel", "Devices"), Qt::LeftDockWidgetArea, "Ctrl+Alt+Shift+D",
       QT_TRANSLATE_NOOP("panel", "Which arms are plugged in, what is missing to use one, and which one is in use."),
       makePanel<DevicesPanel>, "scenes"},
      {"second", QT_TRANSLATE_NOOP("panel", "Second arm"), Qt::LeftDockWidgetArea, "Ctrl+Alt+T",
       QT_TRANSLATE_NOOP("panel", "Another arm beside the first, with a scene of its own."), makePanel<SecondPanel>,
       "scenes"},
      {"hands", QT_TRANSLATE_NOOP("panel", "Hands"), Qt::LeftDockWidgetArea, "Ctrl+Alt+Shift+H",
       QT_TRANSLATE_NOOP("panel", "Mouse, game controllers and 3D mice: which are there, and what moves what."),
       makePanel<HandsPanel>, "scenes"},
      {"lessons", QT_TRANSLATE_NOOP("panel", "Lessons"), Qt::LeftDockWidgetArea, "Ctrl+L",
       QT_TRANSLATE_NOOP("panel", "Exercises in robot kinematics and forces, checked by what the hand does."),
       makePanel<LessonsPanel>, "scenes"},
      {"servo", QT_TRANSLATE_NOOP("panel", "Servo"), Qt::LeftDockWidgetArea, "Ctrl+Alt+9",
       QT_TRANSLATE_NOOP("panel", "How evenly the servo ticks, which limits cut the force, how it is scheduled."),
       makePanel<ServoPanel>, "scenes"},
      {"step", QT_TRANSLATE_NOOP("panel", "Step response"), Qt::LeftDockWidgetArea, "Ctrl+Alt+B",
       QT_TRANSLATE_NOOP("panel",
                         "How the tip follows a target that jumps: rise, settling, overshoot, poles, and the "
                         "arm measured beside the model."),
       makePanel<StepPanel>, "scenes"},
      {"lab", QT_TRANSLATE_NOOP("panel", "Lab"), Qt::LeftDockWidgetArea, "Ctrl+Alt+Q",
       QT_TRANSLATE_NOOP("panel", "What each choice between speed and accuracy costs, and a slider along the best."),
       makePanel<LabPanel>, "scenes"},
      {"sessions", QT_TRANSLATE_NOOP("panel", "Sessions"), Qt::LeftDockWidgetArea, "Ctrl+Alt+N",
       QT_TRANSLATE_NOOP("panel", "Record, mark, and find what was recorded."), makePanel<SessionsPanel>, "scenes"},
      {"session", QT_TRANSLATE_NOOP("panel", "Session plots"), Qt::BottomDockWidgetArea, "Ctrl+Alt+P",
       QT_TRANSLATE_NOOP("panel", "The whole session that is replayed, in plots: force, angles, energy, spectrum."),
       makePanel<SessionPanel>, "plots"},
  }};
  return kRows;
}

}  // namespace underact::gui
