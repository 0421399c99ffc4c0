#pragma once

class QCheckBox;
class QWidget;

namespace underact::gui {

class OptionalSection;
class SettingRows;

// The parts of the Feel panel that are rows of settings; each row goes into `rows`.

/// How much of the stylus's turn goes into the target: for a circle, cylinder or sphere.
OptionalSection* makeInfluence(SettingRows& rows, QWidget* parent);
/// How the surface holds the stylus: its friction, and, of a mesh, how far its force may lean so that bends feel round,
/// and how its nearest point is sought. For what one can slide along.
OptionalSection* makeSurface(SettingRows& rows, QWidget* parent);
/// How a curve leads the hand along it. backwards: the row has the guide's speed; this, which way it goes.
OptionalSection* makeGuide(SettingRows& rows, QCheckBox*& backwards, QWidget* parent);
/// How the rate of the error is found, and whether the energy is watched: folded away until it is asked for.
QWidget* makeRate(SettingRows& rows, QWidget* parent);

}  // namespace underact::gui
