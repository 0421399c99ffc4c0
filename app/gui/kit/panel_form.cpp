#include "app/gui/kit/panel_form.h"

#include <QFormLayout>

namespace underact::gui {

QFormLayout* panelForm() {
  auto* const form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  return form;
}

}  // namespace underact::gui
