#include "app/gui/mesh/mesh_dialog.h"

#include <QApplication>
#include <QButtonGroup>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

constexpr double kDefaultStatic = 0.4, kDefaultDynamic = 0.3;  // about wood on wood
constexpr double kMaxFriction = 1.5;

QString formatText(mesh_file::Format format) {
  switch (format) {
    case mesh_file::Format::StlBinary:
      return QObject::tr("STL (binary)");
    case mesh_file::Format::StlText:
      return QObject::tr("STL (text)");
    case mesh_file::Format::Obj:
      return "OBJ";
    case mesh_file::Format::Ply:
      return "PLY";
    case mesh_file::Format::Off:
      return "OFF";
  }
  return {};
}

QDoubleSpinBox* shareField(const char* name, const QString& spoken, double value, QWidget* parent) {
  auto* field = new NumberBox(parent);
  field->setObjectName(name);
  field->setAccessibleName(spoken);
  field->setRange(0.0, kMaxFriction);
  field->setDecimals(2);
  field->setSingleStep(0.05);
  field->setValue(value);
  return field;
}

}  // namespace

MeshDialog::MeshDialog(const QString& path, const mesh_file::Loaded& loaded, std::optional<double> mm_per_unit,
                       bool can_add, QWidget* parent)
    : AddDialog("dialog.mesh", tr("Mesh %1"), path, tr("Size of the mesh"), parent),
      loaded_(loaded),
      name_(QFileInfo(path).fileName()),
      mm_per_unit_(mm_per_unit.value_or(1.0)),
      report_(messageLabel("dialog.mesh.report", tr("Report on the mesh"), "", this)) {
  const bool is_to_add = !mm_per_unit;
  if (is_to_add) {
    if (const auto proposal = mesh_file::implausible(mesh_file::largestExtent(loaded.facts))) buildUnits(*proposal);
  }
  column()->addWidget(sectionTitle(tr("Report"), this));
  report_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  column()->addWidget(panelScroll(report_, this), 1);
  if (is_to_add) buildChoices();
  buildFoot(is_to_add, can_add);
  refresh();
  resize(QSize(78 * fontMetrics().averageCharWidth(), (is_to_add ? 30 : 18) * fontMetrics().lineSpacing()));
}

void MeshDialog::buildUnits(const mesh_file::Proposal& proposal) {
  QLabel* question = messageLabel("dialog.mesh.question", tr("Which unit"), "amber", this);
  question->setText(tr("%1 Which unit is the file in?").arg(sentenceText(proposal.sentence)));
  column()->addWidget(question);
  unit_ = new QButtonGroup(this);
  const auto button = [&](const QString& text, double mm_per_unit) {
    auto* made = new QRadioButton(text, this);
    made->setObjectName(QString("dialog.mesh.unit.%1").arg(units_.size()));
    made->setAccessibleName(text);
    unit_->addButton(made, static_cast<int>(units_.size()));
    units_.push_back(mm_per_unit);
    column()->addWidget(made);
  };
  for (const mesh_file::Unit& unit : proposal.units)
    button(tr("In %1: %2 long").arg(QCoreApplication::translate("problem", unit.name), millimetres(unit.size_mm)),
           unit.mm_per_unit);
  button(tr("In millimetres, unchanged"), 1.0);
  unit_->button(0)->setChecked(true);  // the most likely unit
  connect(unit_, &QButtonGroup::idToggled, this, &MeshDialog::refresh);
}

void MeshDialog::buildChoices() {
  auto* rows = new QFormLayout;
  rows->setHorizontalSpacing(12);
  side_ = new QComboBox(this);
  side_->setObjectName("dialog.mesh.side");
  side_->setAccessibleName(tr("How the mesh is felt"));
  if (mesh_file::allowsWalls(loaded_.facts)) {
    side_->addItem(tr("wall, from outside"), static_cast<int>(target::Side::Outside));
    side_->addItem(tr("wall, from inside"), static_cast<int>(target::Side::Inside));
  }
  side_->addItem(tr("surface that holds the tip"), static_cast<int>(target::Side::Both));
  rows->addRow(tr("&Felt as"), side_);
  friction_ = new QCheckBox(tr("F&riction"), this);
  friction_->setObjectName("dialog.mesh.friction");
  friction_->setAccessibleName(tr("Friction"));
  static_ = shareField("dialog.mesh.static", tr("Static friction"), kDefaultStatic, this);
  dynamic_ = shareField("dialog.mesh.dynamic", tr("Dynamic friction"), kDefaultDynamic, this);
  auto* shares = new QHBoxLayout;
  shares->setSpacing(8);
  shares->addWidget(friction_);
  shares->addWidget(new QLabel(tr("static"), this));
  shares->addWidget(static_);
  shares->addWidget(new QLabel(tr("dynamic"), this));
  shares->addWidget(dynamic_);
  shares->addStretch(1);
  rows->addRow(tr("Surface"), shares);
  column()->addLayout(rows);
  for (QDoubleSpinBox* field : {static_, dynamic_}) {
    field->setEnabled(false);
    connect(friction_, &QCheckBox::toggled, field, &QWidget::setEnabled);
  }
  // Dynamic friction never exceeds static friction.
  connect(static_, &QDoubleSpinBox::valueChanged, dynamic_, [this](double max) { dynamic_->setMaximum(max); });
  dynamic_->setMaximum(static_->value());
}

void MeshDialog::buildFoot(bool is_to_add, bool can_add) {
  QPushButton* copy = footButton("copy", tr("C&opy"), tr("Copies the report."));
  connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(text()); });
  layFoot(can_add, is_to_add ? tr("Adds the mesh to the current scene.") : QString(),
          tr("Opens a new scene with only this mesh."));
}

double MeshDialog::mmPerUnit() const {
  return unit_ == nullptr ? mm_per_unit_ : units_[static_cast<std::size_t>(unit_->checkedId())];
}

void MeshDialog::refresh() {
  const mesh_file::Facts& facts = loaded_.facts;
  const double scale = mmPerUnit();
  Vec3 size_mm;
  for (std::size_t axis = 0; axis < 3; ++axis)
    size_mm[static_cast<Eigen::Index>(axis)] = scale * (facts.high[axis] - facts.low[axis]);
  counts()->setText(tr("%1: %2 triangles, %3 vertices, %4.")
                        .arg(formatText(loaded_.format))
                        .arg(facts.faces)
                        .arg(facts.corners)
                        .arg(placeText(size_mm).replace(", ", " × ")));
  QStringList sentences;
  for (const Sentence& sentence : mesh_file::reportOf(facts, scale)) sentences << sentenceText(sentence);
  report_->setText(sentences.join("\n"));
}

QString MeshDialog::text() const {
  return QStringList{name_, counts()->text(), report_->text()}.join('\n');
}

scene::Constraint MeshDialog::constraint() const {
  scene::Mesh mesh;
  mesh.surface = loaded_.surface;
  mesh.loaded_checksum = loaded_.checksum;
  const Vec3 middle = 0.5 * (Vec3(loaded_.facts.low.data()) + Vec3(loaded_.facts.high.data()));
  scene::Constraint constraint = fromFile(std::move(mesh), mmPerUnit(), middle);
  if (side_ != nullptr) constraint.side = static_cast<target::Side>(side_->currentData().toInt());
  if (friction_ != nullptr && friction_->isChecked())
    constraint.friction = scene::Friction{static_->value(), dynamic_->value()};
  return constraint;
}

}  // namespace underact::gui
