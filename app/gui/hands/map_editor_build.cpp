#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/hands/axis_bar.h"
#include "app/gui/hands/hand_words.h"
#include "app/gui/hands/map_editor.h"
#include "app/gui/hands/moving_hands.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/told_label.h"
#include "app/gui/kit/value_row.h"
#include "core/base/units.h"
#include "device/hands/map_file.h"

namespace underact::gui {

namespace hands = device::hands;

namespace {

QString markText() {
  return MapEditor::tr("The mark is the usual value; a double click goes back to it.");
}

}  // namespace

MapEditor::MapEditor(MovingHands& hands, Actions& actions, QWidget* parent)
    : QWidget(parent), hands_(hands), actions_(actions), title_(sectionTitle({}, this)) {
  setObjectName("panel.hands.editor");
  setAccessibleName(tr("What moves what"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  title_->setWordWrap(true);
  column->addWidget(title_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  buildWays(grid);
  column->addLayout(grid);
  column->addWidget(buildOne());
  column->addWidget(asked_ = toldLabel("panel.hands.asked", tr("What to do now"), "amber", this));
  column->addWidget(buildPresses());
  column->addWidget(buildFoot());
}

void MapEditor::buildWays(QGridLayout* grid) {
  auto* group = new QButtonGroup(this);
  for (std::size_t way = 0; way < hands::kWays; ++way) {
    const QString title = wayTitle(static_cast<hands::Way>(way)), name = hands::wayName(static_cast<hands::Way>(way));
    auto* button = new QToolButton(this);
    button->setObjectName("panel.hands.way." + name);
    button->setText(title);
    button->setAccessibleName(title);
    button->setToolTip(tr("Shows what moves it: what %1.").arg(wayGoal(static_cast<hands::Way>(way))));
    button->setCheckable(true);
    button->setProperty("role", "choice");
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    group->addButton(button);
    ways_[way] = button;
    bars_[way] = new AxisBar("panel.hands.bar." + name, title, this);
    const int row = static_cast<int>(way);
    grid->addWidget(button, row, 0);
    grid->addWidget(bars_[way], row, 1);
    connect(button, &QToolButton::clicked, this, [this, way] { chooseWay(way); });
  }
  grid->setColumnStretch(1, 1);
}

QWidget* MapEditor::buildOne() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(way_title_ = sectionTitle({}, box));
  source_ = chooser("panel.hands.source", tr("Moved by"), tr("The stick, buttons or triggers that move it."), box);
  learn_ = pushButton("panel.hands.learn", tr("Learn…"), tr("Takes the stick that you push next."), box);
  inverted_ = new QCheckBox(tr("The other way round"), box);
  inverted_->setObjectName("panel.hands.inverted");
  inverted_->setAccessibleName(tr("The other way round"));
  inverted_->setToolTip(tr("Right becomes left, up becomes down."));
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  line->addWidget(source_, 1);
  line->addWidget(learn_);
  column->addLayout(line);
  column->addWidget(inverted_);
  const QString widest = tr("Dead zone");
  const auto row = [&](const char* name, const QString& title, ValueKind kind) {
    kind.mark = markText();
    auto* made = new ValueRow(kind, QString("panel.hands.") + name, box);
    made->setLabel(title, title, widest);
    column->addWidget(made);
    return made;
  };
  zone_ = row("dead_zone", tr("Dead zone"), {tr("So much of the stick's way does nothing."), "%", 1, 50, 0, 90.0});
  fine_ = row("fine", tr("Fine"),
              {tr("How fine it is near the middle: the speed grows with the way to the power 1 + this. 0: evenly."), "",
               10, 30, 1, hands::kFinest - 1.0});
  speed_ = row("speed", tr("Speed"),
               {tr("Of the tip, with the stick at its end."), tr("mm/s"), 1, 300, 0,
                hands::kFastest_m_per_s * kMillimetrePerMetre});
  turn_speed_ = row(
      "turn_speed", tr("Speed"),
      {tr("Of the turn, with the stick at its end."), tr("°/s"), 1, 180, 0, hands::kFastest_rad_per_s / kRadPerDegree});
  connect(source_, &QComboBox::activated, this, [this] { set(field("source"), source_->currentData()); });
  connect(learn_, &QPushButton::clicked, this, [this] { learn(hands::wayName(static_cast<hands::Way>(way_))); });
  connect(inverted_, &QCheckBox::clicked, this, [this](bool on) { set(field("inverted"), on); });
  connect(zone_, &ValueRow::changed, this, [this](double v, bool fresh) { set(field("dead_zone"), v / 100.0, fresh); });
  connect(fine_, &ValueRow::changed, this, [this](double v, bool fresh) { set(field("exponent"), v + 1.0, fresh); });
  connect(speed_, &ValueRow::changed, this,
          [this](double v, bool fresh) { set(field("top"), v * kMetrePerMillimetre, fresh); });
  connect(turn_speed_, &ValueRow::changed, this,
          [this](double v, bool fresh) { set(field("top"), v * kRadPerDegree, fresh); });
  return box;
}

QWidget* MapEditor::buildPresses() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->addWidget(sectionTitle(tr("Buttons"), box), 0, 0, 1, 3);
  for (std::size_t press = 0; press < hands::kPresses; ++press) {
    const QString title = pressTitle(static_cast<hands::Press>(press)),
                  name = hands::pressName(static_cast<hands::Press>(press));
    const QByteArray object = ("panel.hands.press." + name).toLatin1();
    presses_[press] = chooser(object.constData(), title, tr("The button that is this one."), box);
    press_learns_[press] = pushButton("panel.hands.learn." + name, tr("Learn…"),
                                      tr("Takes the button that you press next."), box, tr("Learn %1").arg(title));
    auto* label = new QLabel(title, box);
    label->setBuddy(presses_[press]);
    const int row = static_cast<int>(press) + 1;
    grid->addWidget(label, row, 0);
    grid->addWidget(presses_[press], row, 1);
    grid->addWidget(press_learns_[press], row, 2);
    connect(presses_[press], &QComboBox::activated, this,
            [this, name, press] { set(name, presses_[press]->currentData()); });
    connect(press_learns_[press], &QPushButton::clicked, this, [this, name] { learn(name); });
  }
  grid->setColumnStretch(1, 1);
  return box;
}

QWidget* MapEditor::buildFoot() {
  auto* box = new QWidget(this);
  auto* line = new QHBoxLayout(box);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(8);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    auto* made = pushButton(QString("panel.hands.") + name, text, tip, box);
    connect(made, &QPushButton::clicked, this, [this, name] { actions_.perform(QString("hands.") + name); });
    line->addWidget(made);
    return made;
  };
  undo_ = button("undo", tr("Undo"), tr("Takes the last change of a mapping back."));
  redo_ = button("redo", tr("Redo"), tr("Makes the change again."));
  reset_ = button("reset", tr("As usual"), tr("Puts all of this device back to the usual mapping."));
  line->addStretch(1);
  return box;
}

}  // namespace underact::gui
