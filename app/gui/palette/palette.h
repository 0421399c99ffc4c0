#pragma once
#include <QDialog>
#include <vector>

#include "app/gui/palette/entries.h"

class QLabel;
class QLineEdit;
class QListWidget;

namespace underact::gui {

/// Finds what the window can do by a few letters of its name, in any of its languages: commands, scenes, lessons, pages
/// of the guide, fields of panels. Enter does it, Esc closes.
class Palette : public QDialog {
  Q_OBJECT
 public:
  Palette(std::vector<PaletteEntry> entries, QWidget* window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show(const QString& typed);
  void run();

  std::vector<PaletteEntry> entries_;
  std::vector<const PaletteEntry*> shown_;
  QLineEdit* words_;
  QListWidget* list_;
  QLabel* note_;
};

}  // namespace underact::gui
