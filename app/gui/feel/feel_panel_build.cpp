// How the Feel panel is put together; what it does is in feel_panel.cpp.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/feature/gain_row.h"
#include "app/gui/feel/feel_panel.h"
#include "app/gui/feel/guide_section.h"
#include "app/gui/feel/influence_section.h"
#include "app/gui/feel/rate_section.h"
#include "app/gui/feel/surface_section.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/told_label.h"
#include "app/gui/model/document.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/model/setting_words.h"

namespace underact::gui {
FeelPanel::FeelPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  addActions();
  addSwitches();
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  buildChoices(column);
  buildGains(column);
  influence_ = new InfluenceSection(this);
  column->addWidget(influence_);
  connect(influence_, &InfluenceSection::changed, this, &FeelPanel::setInfluence);
  surface_ = new SurfaceSection(this);
  column->addWidget(surface_);
  connect(surface_, &SurfaceSection::frictionChanged, this, &FeelPanel::setFriction);
  connect(surface_, &SurfaceSection::asked, this, &FeelPanel::set);
  guide_ = new GuideSection(this);
  column->addWidget(guide_);
  connect(guide_, &GuideSection::changed, this, &FeelPanel::setGuide);
  rate_ = new RateSection(this);
  column->addWidget(rate_);
  connect(rate_, &RateSection::asked, this, &FeelPanel::set);
  column->addStretch(1);
  QScrollArea* scroll = panelScroll(content, this);
  scroll->setMinimumWidth(content->minimumSizeHint().width() + 16);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(0);
  outer->addWidget(scroll, 1);
  buildFoot(outer);
  connect(&parts_.document, &Document::opened, this, &FeelPanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &FeelPanel::sceneEdited);
  connect(&parts_.rate, &ServoRate::changed, this, [this] { stale_ = true; });  // what may buzz depends on it
  sceneOpened();
}

void FeelPanel::buildChoices(QVBoxLayout* column) {
  choices_ = new QFormLayout;
  choices_->setHorizontalSpacing(12);
  choices_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  constraint_ = chooser("panel.feel.constraint", tr("Constraint whose gains are shown"),
                        tr("Which constraint of the scene the gains below belong to."), this);
  law_ = chooser("panel.feel.law", tr("Control law"), settingTip("/control/law"), this);
  law_->addItems({tr("P, proportional"), tr("PD, with damping"), tr("PID, with integral")});
  anisotropy_ =
      chooser("panel.feel.anisotropy", tr("Nearest point with unequal gains"), settingTip("/control/anisotropy"), this);
  anisotropy_->addItems({tr("by effort (weighted)"), tr("by distance (euclidean)")});
  space_ = chooser("panel.feel.space", tr("Where the control works"), settingTip("/control/space"), this);
  space_->addItems({tr("the tip (Cartesian)"), tr("the joints")});
  choices_->addRow(tr("&Constraint"), constraint_);
  choices_->addRow(tr("&Law"), law_);
  choices_->addRow(tr("&Works on"), space_);
  choices_->addRow(tr("&Nearest"), anisotropy_);
  column->addLayout(choices_);
  link_ = new QCheckBox(tr("L&ink x, y and z"), this);
  link_->setObjectName("panel.feel.link");
  link_->setAccessibleName(tr("Link x, y and z"));
  link_->setToolTip(tr("A change of one axis changes all three."));
  column->addWidget(link_);

  connect(constraint_, &QComboBox::currentIndexChanged, this, [this](int row) {
    if (row < 0) return;
    index_ = static_cast<std::size_t>(row);
    gesture_ = parts_.document.newGesture();  // keys in a row on another constraint are another step back
    beginInfluence();
    refresh();
  });
  const auto ask = [this](QComboBox* choice, const char* path) {  // its rows are in the order of the table's words
    connect(choice, &QComboBox::currentIndexChanged, this, [this, path](int row) {
      set(path, scene::findSetting(path)->words()[static_cast<std::size_t>(row)], true);
    });
  };
  ask(law_, "/control/law");
  ask(space_, "/control/space");
  ask(anisotropy_, "/control/anisotropy");
}

void FeelPanel::buildGains(QVBoxLayout* column) {
  for (int gain = 0; gain < kGainKinds; ++gain) {
    auto* section = new QWidget(this);
    auto* rows = new QVBoxLayout(section);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(4);
    QLabel* title = sectionTitle(
        QString("%1 %2").arg(QCoreApplication::translate("gain", gainKind(gain).name), gainKind(gain).key), section);
    title->setToolTip(settingTip(gainKind(gain).path));
    rows->addWidget(title);
    for (int axis = 0; axis < 3; ++axis) {
      auto* row = new GainRow(gain, axis, section);
      connect(row, &GainRow::changed, this,
              [this, gain, axis](double value, bool fresh) { setGain(gain, axis, value, fresh); });
      rows->addWidget(row);
      rows_[static_cast<std::size_t>(gain)][static_cast<std::size_t>(axis)] = row;
    }
    sections_[static_cast<std::size_t>(gain)] = section;
    column->addWidget(section);
  }
}

// Below what scrolls: a sentence is always seen, and its coming moves no slider from under the pointer.
void FeelPanel::buildFoot(QVBoxLayout* outer) {
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(12, 8, 12, 8);
  foot->setSpacing(8);
  warning_ = toldLabel("panel.feel.warning", tr("Warning"), "amber", this);
  warning_->setToolTip(
      tr("A sampled wall with one tick of delay stays calm for K < (b + B) / (1.5 T); b: the hand's damping, "
         "B: kd, T: the tick. Lower the stiffness, or hold the stylus firmly."));
  refusal_ = toldLabel("panel.feel.refusal", tr("Why the change was refused"), "alarm", this);
  for (QLabel* label : {warning_, refusal_}) label->hide();
  foot->addWidget(warning_);
  foot->addWidget(refusal_);
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  const QStringList names{"edit.undo", "edit.redo", "gains.reset", "scene.save_as"};
  for (int index = 0; index < names.size(); ++index) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(parts_.actions.find(names[index]));
    button->setObjectName("panel.feel.button." + names[index]);
    button->setAccessibleName(button->defaultAction()->iconText());
    button->setIconSize(QSize(1, 1) * fontMetrics().height());
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
    grid->addWidget(button, index / 2, index % 2);
  }
  foot->addLayout(grid);
  outer->addLayout(foot);
}

}  // namespace underact::gui
