#pragma once
#include <QString>
#include <functional>

#include "app/gui/kit/page_view.h"

namespace underact::gui {

/// A page of Markdown for paper, black on white.
struct PaperPage {
  QString title;
  QString markdown;
  QString folder = {};  // base of relative paths to pictures
  Author author = Author::Stranger;
  bool is_worksheets = false;  // each section begins a sheet, and its tables have room to write in
};

/// Asks for the printer. name: of the dialogs, as "guide" in "dialog.guide_print".
void askToPrint(QWidget* window, const QString& name, const PaperPage& page);

/// Asks where to save the page as PDF. saved: called with its path; what goes wrong is shown in a box.
void askToSavePdf(QWidget* window, const QString& name, const PaperPage& page,
                  std::function<void(const QString& path)> saved);

/// Writes the PDF: all of the file or nothing. Problems: one.
Problems savePdf(const PaperPage& page, const QString& path);

}  // namespace underact::gui
