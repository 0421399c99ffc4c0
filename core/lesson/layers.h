#pragma once
#include <cstdint>
#include <span>

#include "core/base/types.h"

namespace underact::lesson {

/// What the view can show or hide.
struct Layers {
  bool workspace = true;  // the box with ticks every 20 mm
  bool triads = true;     // W and B
  bool arm = true;        // the arm's links, thin
  bool target = true;     // the target point and the error line
  bool force = true;      // the force arrow
  bool influence = true;  // see InfluencePicture; where the scene has one
  bool robot = true;      // virtual manipulators
  bool path = true;       // of a recording that is replayed
  bool desk = true;       // the reference points, where the arm is registered
  bool from_desk = true;  // views are relative to the desk, not to the arm, where it is registered
  // Of meshes, see MeshPicture.
  bool wires = false;              // the edges of all triangles
  bool section = false;            // cut open, across an axis of W
  int section_axis = 2;            // 0 x, 1 y, 2 z
  bool section_follows = true;     // the cut goes through the tip; else it stays where it is
  Vec3 section_mm = Vec3::Zero();  // across each axis where the cut is; follows the tip with it
  // For teaching, see KinematicsPicture.
  bool link_frames = false;
  bool ghosts = false;            // the inverse solutions
  bool motion_ellipsoid = false;  // of manipulability
  bool force_ellipsoid = false;
  bool operator==(const Layers&) const = default;
};

/// A row of the table of layers, in the order of the menu: what a step of a lesson may ask for, the window's actions
/// layer.NAME, and what it remembers. Text, tip and button are for translators, in the context "layer".
struct Layer {
  /// The part of the menu that it is in.
  enum class Group : std::uint8_t { Scene, Teaching, Mesh };
  const char* name;
  bool Layers::*shown;
  Group group;
  const char *text, *shortcut, *tip;
  const char* button = nullptr;  // a shorter text
};

/// All layers, in the order of the menu.
std::span<const Layer> layers();

}  // namespace underact::lesson
