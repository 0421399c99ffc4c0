#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/servo/sections.h"

namespace underact::gui {

SchedulingSection::SchedulingSection(QWidget* parent)
    : Section("scheduling", tr("Scheduling"), tr("The scheduling that the system granted to the servo thread."), parent,
              "servo"),
      name_(quietLabel("panel.servo.scheduling.name", {}, this)),
      also_(quietLabel("panel.servo.scheduling.also", {}, this)),
      hint_(quietLabel("panel.servo.scheduling.hint", {}, this)) {
  name_->setProperty("role", "");
  name_->setAccessibleName(tr("Scheduling in effect"));
  also_->setAccessibleName(tr("Also granted"));
  hint_->setAccessibleName(tr("How to improve it"));
  for (QLabel* label : {name_, also_, hint_}) {
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column().addWidget(label);
  }
}

void SchedulingSection::present(const system::Scheduling& scheduling) {
  const QString name = schedulingText(scheduling);
  if (name_->text() != name) name_->setText(name);
  const QString also = phrasesOf(scheduling.also);
  showMessage(also_, also);
  const QString hint = scheduling.hint.empty() ? tr("There is nothing to improve.") : sentenceText(scheduling.hint);
  if (hint_->text() != hint) hint_->setText(hint);
}

}  // namespace underact::gui
