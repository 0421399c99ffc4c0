#include "app/gui/feature/setting_rows.h"

#include <QBoxLayout>
#include <QFormLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "app/gui/arms/joint_fields.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/focus_wheel.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/model/document.h"
#include "app/gui/model/setting_words.h"

namespace underact::gui {
namespace {

using scene::SettingValue;

std::string inTable(const SettingRowSpec& spec) {
  return std::string("/constraints/*") + spec.path;
}

std::function<void(bool)> showsRow(QFormLayout* form, QWidget* widget) {
  return [form, widget](bool on) { form->setRowVisible(widget, on); };
}

}  // namespace

ValueRow* SettingRows::makeNumber(const SettingRowSpec& spec, QWidget* parent) {
  const std::string path = inTable(spec);
  auto* const row = new ValueRow({settingTip(path), settingUnit(path), spec.steps_per_unit, spec.slider_steps,
                                  spec.decimals, spec.max > 0.0 ? spec.max : settingMax(path)},
                                 spec.name, parent);
  row->setLabel(spec.label, spec.spoken, spec.widest);
  connect(row, &ValueRow::changed, this,
          [this, at = std::string(spec.path)](double value, bool fresh) { emit asked(at, value, fresh); });
  const auto show = [row](const SettingValue& now, const SettingValue& own) {
    // Its magnitude; where it may be negative, something beside the row says so.
    const double* const marked = std::get_if<double>(&own);
    row->present(std::abs(std::get<double>(now)), marked ? std::optional(std::abs(*marked)) : std::nullopt);
  };
  rows_.push_back({spec.path, show, {}, row});
  return row;
}

ValueRow* SettingRows::addNumber(const SettingRowSpec& spec, QBoxLayout* into, QWidget* parent) {
  ValueRow* const row = makeNumber(spec, parent);
  rows_.back().show = [row](bool on) { row->setVisible(on); };
  into->addWidget(row);
  return row;
}

ValueRow* SettingRows::addNumber(const SettingRowSpec& spec, QFormLayout* into, QWidget* parent) {
  ValueRow* const row = makeNumber(spec, parent);
  rows_.back().show = showsRow(into, row);
  into->addRow(row);
  return row;
}

QComboBox* SettingRows::addChoice(const SettingRowSpec& spec, QFormLayout* into, QWidget* parent) {
  const std::string path = inTable(spec);
  auto* const box = chooser(spec.name, spec.spoken, settingTip(path), parent);
  for (const std::string& word : spec.order.empty() ? scene::findSetting(path)->words() : spec.order)
    box->addItem(settingChoice(path, word), QString::fromStdString(word));
  connect(box, &QComboBox::currentIndexChanged, this, [this, box, at = std::string(spec.path)](int row) {
    emit asked(at, box->itemData(row).toString().toStdString(), true);
  });
  const auto show = [box](const SettingValue& now, const SettingValue&) {
    const QSignalBlocker silent(box);  // showing a value must not emit a change
    box->setCurrentIndex(box->findData(QString::fromStdString(std::get<std::string>(now))));
  };
  into->addRow(spec.label, box);
  rows_.push_back({spec.path, show, showsRow(into, box)});
  return box;
}

QSpinBox* SettingRows::addWhole(const SettingRowSpec& spec, QFormLayout* into, QWidget* parent) {
  const scene::Setting& setting = *scene::findSetting(inTable(spec));
  auto* const box = new FocusWheel<QSpinBox>(parent);
  nameWidget(box, spec.name, spec.spoken, settingTip(inTable(spec)));
  box->setRange(static_cast<int>(setting.min), static_cast<int>(setting.max));
  box->setKeyboardTracking(false);
  box->setFocusPolicy(Qt::StrongFocus);
  connect(box, &QSpinBox::valueChanged, this,
          [this, at = std::string(spec.path)](int value) { emit asked(at, static_cast<double>(value), true); });
  const auto show = [box](const SettingValue& now, const SettingValue&) {
    const QSignalBlocker silent(box);
    box->setValue(static_cast<int>(std::get<double>(now)));
  };
  into->addRow(spec.label, box);
  rows_.push_back({spec.path, show, showsRow(into, box)});
  return box;
}

QLineEdit* SettingRows::addText(const SettingRowSpec& spec, QFormLayout* into, QWidget* parent) {
  auto* const line = new QLineEdit(parent);
  nameWidget(line, spec.name, spec.spoken, settingTip(inTable(spec)));
  connect(line, &QLineEdit::editingFinished, this, [this, line, at = std::string(spec.path)] {
    if (!line->isModified()) return;
    line->setModified(false);
    const Result<double> number = typedNumber(line->text());
    if (number)
      emit asked(at, number.value(), true);
    else
      emit refused(number.problems());
  });
  const auto show = [line](const SettingValue& now, const SettingValue&) {
    line->setText(exactNumber(std::get<double>(now)));
  };
  into->addRow(spec.label, line);
  rows_.push_back({spec.path, show, showsRow(into, line)});
  return line;
}

void SettingRows::present(const Document& document, std::size_t index,
                          const std::function<bool(const std::string&)>& is_idle) {
  for (const SettingRow& row : rows_) {
    const SettingValue now = document.value(index, row.path);
    const bool is_there = !scene::isNone(now);
    row.show(is_there && !(is_idle && is_idle(row.path)));
    if (is_there) row.present(now, document.own(index, row.path));
  }
}

bool SettingRows::isHeld() const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [](const SettingRow& row) { return row.slider != nullptr && row.slider->isHeld(); });
}

}  // namespace underact::gui
