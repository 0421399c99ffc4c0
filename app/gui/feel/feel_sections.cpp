#include "app/gui/feel/feel_sections.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/feature/setting_rows.h"
#include "app/gui/feel/feel_panel.h"
#include "app/gui/feel/optional_section.h"
#include "app/gui/kit/panel_form.h"
#include "app/gui/kit/section.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/value_row.h"

namespace underact::gui {

OptionalSection* makeInfluence(SettingRows& rows, QWidget* parent) {
  auto* const made = new OptionalSection(
      {.name = "panel.influence",
       .title = FeelPanel::tr("Influence t"),
       .title_tip = FeelPanel::tr(
           "Where the target lies on the circle, cylinder or sphere, between the point that the stylus points at and "
           "the point nearest to the tip: theta = alpha + t wrap(beta - alpha) (thesis equation 5.3)."),
       .switch_name = "panel.influence.on",
       .switch_text = FeelPanel::tr("&Use stylus orientation"),
       .switch_spoken = FeelPanel::tr("Use stylus orientation"),
       .switch_tip = FeelPanel::tr(
           "Off: the target is the point nearest to the tip. On: rotating the stylus moves the target, too."),
       .turned_on = FeelPanel::tr("influence on"),
       .turned_off = FeelPanel::tr("influence off"),
       .easy = {{"/influence/t", 0.5}, {"/influence/stylus_axis", "+z"}, {"/influence/blend_deg", 5.0}}},
      parent);
  const QString blend = FeelPanel::tr("Blend");
  rows.addNumber({"/influence/t", "panel.influence.t", "t", FeelPanel::tr("Influence t"), blend, 100, 100, 3},
                 made->rows(), made->details())
      ->setEnds(FeelPanel::tr("orientation"), FeelPanel::tr("position"));
  QFormLayout* const form = panelForm();
  made->rows()->addLayout(form);
  rows.addChoice({"/influence/stylus_axis", "panel.influence.axis", FeelPanel::tr("&Stylus axis"),
                  FeelPanel::tr("Stylus axis that points at the target")},
                 form, made->details())
      ->setMinimumContentsLength(8);
  rows.addNumber(
      {"/influence/blend_deg", "panel.influence.blend", blend, FeelPanel::tr("Blend width"), blend, 2, 60, 1},
      made->rows(), made->details());
  return made;
}

OptionalSection* makeSurface(SettingRows& rows, QWidget* parent) {
  auto* const made = new OptionalSection(
      {.name = "panel.surface",
       .title = FeelPanel::tr("Surface"),
       .title_tip = {},
       .switch_name = "panel.surface.friction",
       .switch_text = FeelPanel::tr("F&riction"),
       .switch_spoken = FeelPanel::tr("Friction"),
       .switch_tip = FeelPanel::tr("Off: the stylus slides freely along the surface. On: it sticks until the force "
                                   "along the surface exceeds the static coefficient times the normal force; then it "
                                   "slides against the dynamic coefficient times the normal force (Coulomb)."),
       .turned_on = FeelPanel::tr("friction on"),
       .turned_off = FeelPanel::tr("friction off"),
       .easy = {{"/friction/static", 0.4}, {"/friction/dynamic", 0.3}}},  // about wood on wood
      parent);
  const QString widest = FeelPanel::tr("Dynamic");
  rows.addNumber({"/friction/static", "panel.surface.static", FeelPanel::tr("Static"), FeelPanel::tr("Static friction"),
                  widest, 100, 150, 2},
                 made->rows(), made->details());
  rows.addNumber(
      {"/friction/dynamic", "panel.surface.dynamic", widest, FeelPanel::tr("Dynamic friction"), widest, 100, 150, 2},
      made->rows(), made->details());
  rows.addNumber(
      {"/smooth_deg", "panel.surface.smooth", FeelPanel::tr("Smooth"), FeelPanel::tr("Smooth bends"), widest, 1, 45, 1},
      made->column(), made);
  QFormLayout* const form = panelForm();
  made->column()->addLayout(form);
  rows.addChoice({"/search", "panel.surface.search", FeelPanel::tr("Se&arch"),
                  FeelPanel::tr("Search for the nearest point of the mesh")},
                 form, made);
  return made;
}

OptionalSection* makeGuidance(SettingRows& rows, QCheckBox*& backwards, QWidget* parent) {
  auto* const made = new OptionalSection(
      {.name = "panel.guide",
       .title = FeelPanel::tr("Guidance"),
       .title_tip = {},
       .switch_name = "panel.guide.on",
       .switch_text = FeelPanel::tr("&Guide the hand"),
       .switch_spoken = FeelPanel::tr("Guide the hand along the curve"),
       .switch_tip = FeelPanel::tr("Off: the target is the nearest point of the curve. On: a guide point runs ahead of "
                                   "the hand along the curve, pulls it along and waits for it."),
       .turned_on = FeelPanel::tr("guidance on"),
       .turned_off = FeelPanel::tr("guidance off"),
       .easy = {{"/guide/speed_mm_per_s", 30.0}, {"/guide/t", 0.0}, {"/guide/lead_mm", 8.0}}},
      parent);
  const QString widest = FeelPanel::tr("Speed");
  rows.addNumber(
      {"/guide/speed_mm_per_s", "panel.guide.speed", widest, FeelPanel::tr("Speed of the guide"), widest, 1, 200, 0},
      made->rows(), made->details());
  backwards = new QCheckBox(FeelPanel::tr("Bac&kwards"), made->details());
  backwards->setObjectName("panel.guide.backwards");
  backwards->setAccessibleName(FeelPanel::tr("The guide runs backwards"));
  made->rows()->addWidget(backwards);
  rows.addNumber({"/guide/t", "panel.guide.t", "t", FeelPanel::tr("Influence of the hand's position on the curve"),
                  widest, 100, 100, 2},
                 made->rows(), made->details())
      ->setEnds(FeelPanel::tr("guide"), FeelPanel::tr("nearest"));
  rows.addNumber({"/guide/lead_mm", "panel.guide.lead", FeelPanel::tr("Lead"), FeelPanel::tr("Lead of the guide"),
                  widest, 1, 50, 1},
                 made->rows(), made->details());
  return made;
}

QWidget* makeRate(SettingRows& rows, QWidget* parent) {
  auto* const made = new QWidget(parent);
  made->setObjectName("panel.rate");
  auto* const outer = tight<QVBoxLayout>(made);
  auto* const section = new Section(
      "rate", FeelPanel::tr("Velocity and energy"),
      FeelPanel::tr("How the velocity for damping is estimated, and whether the energy of the constraint is observed."),
      made, "feel");
  outer->addWidget(section);
  QFormLayout* const form = panelForm();
  section->column().addLayout(form);
  section->findChild<QToolButton*>("panel.feel.rate.fold")->setChecked(false);
  const QString widest = FeelPanel::tr("Setting");
  rows.addChoice(
      {"/control/velocity/filter", "panel.rate.filter", FeelPanel::tr("&Velocity"), FeelPanel::tr("Velocity filter")},
      form, made);
  rows.addNumber({"/control/velocity/acceleration_mm_per_s2", "panel.rate.acceleration", widest,
                  FeelPanel::tr("Acceleration"), widest, 1, 30000, 0, 100000.0},
                 form, made);
  rows.addNumber({"/control/velocity/time_constant_ms", "panel.rate.time_constant", widest,
                  FeelPanel::tr("Time constant"), widest, 10, 200, 1},
                 form, made);
  rows.addNumber(
      {"/control/velocity/window", "panel.rate.window", widest, FeelPanel::tr("Longest window"), widest, 1, 32, 0},
      form, made);
  SettingRowSpec passivity{"/control/passivity", "panel.rate.passivity", FeelPanel::tr("&Passivity"),
                           FeelPanel::tr("Passivity")};
  passivity.order = {"off", "observe", "control"};
  rows.addChoice(passivity, form, made);
  return made;
}

}  // namespace underact::gui
