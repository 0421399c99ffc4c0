#pragma once
#include <QObject>
#include <QStringList>

class QToolBar;

namespace underact::gui {

/// Takes the words from the buttons of a tool bar while the window is too narrow for them, so that none is pushed out
/// of it and the view keeps its room; their tips say them.
class NarrowBar : public QObject {
 public:
  /// A bar along the window's upper edge: one button after another, until all fit. buttons: object names, the first
  /// loses its words first.
  NarrowBar(QToolBar* bar, QStringList buttons);
  /// A bar along a side: all at once where the window is narrower than that, px. With words, all are equally wide.
  NarrowBar(QToolBar* bar, int words_from_px);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fitAlong();
  void fitBeside();

  QToolBar* bar_;
  QStringList buttons_;
  int words_from_px_ = 0;  // 0: along the upper edge
  bool is_fitted_ = false;
};

}  // namespace underact::gui
