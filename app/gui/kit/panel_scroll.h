#pragma once

class QScrollArea;
class QWidget;

namespace underact::gui {

/// What a panel's content scrolls in: up and down alone, without a frame, no stop of the Tab key.
QScrollArea* panelScroll(QWidget* content, QWidget* parent);

/// Fills a panel with content that scrolls, as wide at least as its words.
void fillWithScroll(QWidget* panel, QWidget* content);

}  // namespace underact::gui
