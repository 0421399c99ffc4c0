#pragma once

class QCheckBox;
class QWidget;

namespace underact::gui {

class OptionalSection;
class SettingRows;

// The sections of the Feel panel that consist of rows of settings; each row is added to `rows`.

/// The influence of the stylus orientation on the target of a circle, cylinder or sphere.
OptionalSection* makeInfluence(SettingRows& rows, QWidget* parent);
/// Friction of a shape that the tip can slide along; for a mesh, also the smoothing of bends and the search for the
/// nearest point.
OptionalSection* makeSurface(SettingRows& rows, QWidget* parent);
/// The guidance along a curve. backwards: the direction of the guide; the row of the speed has its magnitude.
OptionalSection* makeGuidance(SettingRows& rows, QCheckBox*& backwards, QWidget* parent);
/// The velocity filter and the passivity observer or controller; folded at first.
QWidget* makeRate(SettingRows& rows, QWidget* parent);

}  // namespace underact::gui
