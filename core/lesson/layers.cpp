#include "core/lesson/layers.h"

#include "core/base/translate.h"

namespace underact::lesson {

std::span<const Layer> layers() {
  using Group = Layer::Group;
  static constexpr Layer kAll[] = {
      {"workspace", &Layers::workspace, Group::Scene, TRANSLATE_NOOP("layer", "&Workspace box"), "Alt+1",
       TRANSLATE_NOOP("layer", "The box the arm can reach, with ticks every 20 mm.")},
      {"triads", &Layers::triads, Group::Scene, TRANSLATE_NOOP("layer", "&Axes of W and B"), "Alt+2",
       TRANSLATE_NOOP("layer", "The axes of the workspace and of the arm's base.")},
      {"arm", &Layers::arm, Group::Scene, TRANSLATE_NOOP("layer", "A&rm"), "Alt+3",
       TRANSLATE_NOOP("layer", "The arm's links.")},
      {"target", &Layers::target, Group::Scene, TRANSLATE_NOOP("layer", "&Target and error"), "Alt+4",
       TRANSLATE_NOOP("layer", "The point to which the tip is pulled, and the line to it.")},
      {"force", &Layers::force, Group::Scene, TRANSLATE_NOOP("layer", "&Force"), "Alt+5",
       TRANSLATE_NOOP("layer", "The force that is sent, as an arrow.")},
      {"influence", &Layers::influence, Group::Scene, TRANSLATE_NOOP("layer", "&Influence"), "Ctrl+Alt+I",
       TRANSLATE_NOOP("layer",
                      "The point that the stylus points at (o), the point nearest to the tip (p), and the arc of the "
                      "target between them.")},
      {"robot", &Layers::robot, Group::Scene, TRANSLATE_NOOP("layer", "&Virtual robot"), "Ctrl+Alt+R",
       TRANSLATE_NOOP(
           "layer", "The virtual robots with their joints, and the directions in which their end effectors can move.")},
      {"path", &Layers::path, Group::Scene, TRANSLATE_NOOP("layer", "Recorded &path"), "Alt+P",
       TRANSLATE_NOOP("layer", "The path of the tip in the replayed session; the more force, the more vermillion.")},
      {"desk", &Layers::desk, Group::Scene, TRANSLATE_NOOP("layer", "&Desk"), "Ctrl+Alt+Shift+K",
       TRANSLATE_NOOP("layer", "The reference points on the desk with which the arm was registered.")},
      {"from_desk", &Layers::from_desk, Group::Scene, TRANSLATE_NOOP("layer", "As se&en from the desk"),
       "Ctrl+Alt+Shift+V",
       TRANSLATE_NOOP(
           "layer",
           "Left, right and up are those of the desk, however a registered arm is turned. Off: those of the arm.")},
      {"link_frames", &Layers::link_frames, Group::Teaching, TRANSLATE_NOOP("layer", "&Link frames"), "Alt+6",
       TRANSLATE_NOOP(
           "layer",
           "The frames 1 to 6 of the DH table along the arm; each number is at the end of the z axis of its joint.")},
      {"ghosts", &Layers::ghosts, Group::Teaching, TRANSLATE_NOOP("layer", "Inver&se solutions"), "Alt+7",
       TRANSLATE_NOOP("layer",
                      "All configurations in which the arm reaches the pose of the stylus, as ghosts; dashed: outside "
                      "the joint limits.")},
      {"motion_ellipsoid", &Layers::motion_ellipsoid, Group::Teaching, TRANSLATE_NOOP("layer", "&Motion ellipsoid (v)"),
       "Alt+8",
       TRANSLATE_NOOP("layer",
                      "The motions of the tip for joint rotations of magnitude 0.25 rad (manipulability ellipsoid).")},
      {"force_ellipsoid", &Layers::force_ellipsoid, Group::Teaching, TRANSLATE_NOOP("layer", "F&orce ellipsoid (f)"),
       "Alt+9",
       TRANSLATE_NOOP("layer",
                      "The forces for joint torques of one magnitude, which the panel Kinematics names, to the scale "
                      "of the force arrow.")},
      {"wires", &Layers::wires, Group::Mesh, TRANSLATE_NOOP("layer", "Mes&h: triangles"), "Alt+T",
       TRANSLATE_NOOP("layer", "The edges of all triangles of a mesh as drawn.")},
      {"section", &Layers::section, Group::Mesh, TRANSLATE_NOOP("layer", "Mesh: &cut open"), "Alt+C",
       TRANSLATE_NOOP(
           "layer",
           "Cuts meshes open perpendicular to an axis and hides the side nearer to you. What you feel is not cut.")},
      {"section_follows", &Layers::section_follows, Group::Mesh, TRANSLATE_NOOP("layer", "C&ut follows the stylus"),
       "Alt+K", TRANSLATE_NOOP("layer", "The cut passes through the tip. Off: it stays where it is."),
       TRANSLATE_NOOP("layer", "Follow")}};
  return kAll;
}

}  // namespace underact::lesson
