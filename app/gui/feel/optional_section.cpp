#include "app/gui/feel/optional_section.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/model/document.h"

namespace underact::gui {
OptionalSection::OptionalSection(Labels looks, QWidget* parent)
    : QWidget(parent),
      poll_timer_(std::move(looks)),
      last_(poll_timer_.easy),
      column_(tight<QVBoxLayout>(this, 4)),
      on_(new QCheckBox(poll_timer_.switch_text, this)),
      details_(new QWidget(this)),
      rows_(tight<QVBoxLayout>(details_, 4)) {
  setObjectName(poll_timer_.name);
  QLabel* const title = sectionTitle(poll_timer_.title, this);
  title->setToolTip(poll_timer_.title_tip);
  on_->setObjectName(poll_timer_.switch_name);
  on_->setAccessibleName(poll_timer_.switch_spoken);
  on_->setToolTip(poll_timer_.switch_tip);
  for (QWidget* const widget : {static_cast<QWidget*>(title), static_cast<QWidget*>(on_), details_})
    column_->addWidget(widget);
  connect(on_, &QCheckBox::toggled, this, &OptionalSection::switchAsked);
}

void OptionalSection::begin(const Document& document, std::size_t index) {
  last_ = poll_timer_.easy;
  if (scene::isNone(document.own(index, last_.front().path))) return;
  for (SettingChange& one : last_) one.value = document.own(index, one.path);
}

bool OptionalSection::isOn(const Document& document, std::size_t index) const {
  return !scene::isNone(document.value(index, last_.front().path));
}

void OptionalSection::present(const Document& document, std::size_t index) {
  const bool is_on = isOn(document, index);
  const QSignalBlocker silent(on_);  // showing a value must not set it
  on_->setChecked(is_on);
  details_->setVisible(is_on);
  if (!is_on) return;
  for (SettingChange& one : last_) one.value = document.value(index, one.path);
}

std::vector<SettingChange> OptionalSection::switched(bool on) const {
  if (on) return last_;
  return {{last_.front().path, {}}};
}

}  // namespace underact::gui
