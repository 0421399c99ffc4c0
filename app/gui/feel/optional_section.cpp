#include "app/gui/feel/optional_section.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/kit/told_label.h"
#include "app/gui/model/document.h"

namespace underact::gui {
namespace {

QVBoxLayout* plainColumn(QWidget* widget) {
  auto* const column = new QVBoxLayout(widget);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  return column;
}

}  // namespace

OptionalSection::OptionalSection(Looks looks, QWidget* parent)
    : QWidget(parent),
      looks_(std::move(looks)),
      last_(looks_.easy),
      column_(plainColumn(this)),
      on_(new QCheckBox(looks_.switch_text, this)),
      details_(new QWidget(this)),
      rows_(plainColumn(details_)) {
  setObjectName(looks_.name);
  QLabel* const title = sectionTitle(looks_.title, this);
  title->setToolTip(looks_.title_tip);
  on_->setObjectName(looks_.switch_name);
  on_->setAccessibleName(looks_.switch_spoken);
  on_->setToolTip(looks_.switch_tip);
  for (QWidget* const widget : {static_cast<QWidget*>(title), static_cast<QWidget*>(on_), details_})
    column_->addWidget(widget);
  connect(on_, &QCheckBox::toggled, this, &OptionalSection::switchAsked);
}

void OptionalSection::begin(const Document& document, std::size_t index) {
  last_ = looks_.easy;
  if (scene::isNone(document.own(index, last_.front().path))) return;
  for (SettingWish& one : last_) one.value = document.own(index, one.path);
}

bool OptionalSection::isOn(const Document& document, std::size_t index) const {
  const Result<scene::SettingValue> value =
      scene::valueAt(document.scene(), "/constraints/" + std::to_string(index) + last_.front().path);
  return value && !scene::isNone(value.value());
}

void OptionalSection::present(const Document& document, std::size_t index) {
  const bool is_on = isOn(document, index);
  const QSignalBlocker silent(on_);  // to show a value is not to ask for it
  on_->setChecked(is_on);
  details_->setVisible(is_on);
  if (!is_on) return;
  const std::string constraint = "/constraints/" + std::to_string(index);
  for (SettingWish& one : last_) one.value = scene::valueAt(document.scene(), constraint + one.path).value();
}

std::vector<SettingWish> OptionalSection::switched(bool on) const {
  if (on) return last_;
  return {{last_.front().path, {}}};
}

}  // namespace underact::gui
