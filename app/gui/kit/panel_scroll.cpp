#include "app/gui/kit/panel_scroll.h"

#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/kit/tight_layout.h"

namespace underact::gui {

QScrollArea* panelScroll(QWidget* content, QWidget* parent) {
  auto* scroll = new QScrollArea(parent);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  return scroll;
}

void fillWithScroll(QWidget* panel, QWidget* content) {
  QScrollArea* scroll = panelScroll(content, panel);
  scroll->setMinimumWidth(content->minimumSizeHint().width() + 16);
  auto* outer = tight<QVBoxLayout>(panel);
  outer->addWidget(scroll);
}

}  // namespace underact::gui
