#pragma once

class QScrollArea;
class QWidget;

namespace underact::gui {

/// The scroll area of a panel: vertical only, without a frame, not in the Tab order.
QScrollArea* panelScroll(QWidget* content, QWidget* parent);

/// Fills a panel with content that scrolls; the content is at least as wide as its texts.
void fillWithScroll(QWidget* panel, QWidget* content);

}  // namespace underact::gui
