#include "app/gui/kit/page_print.h"

#include <QApplication>
#include <QBuffer>
#include <QLocale>
#include <QPdfWriter>
#include <QPrintDialog>
#include <QPrinter>
#include <QSaveFile>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>
#include <QUrl>
#include <algorithm>

#include "app/gui/kit/file_question.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"
#include "app/page/page.h"
#include "app/page/style.h"
#include "core/base/translate.h"

namespace underact::gui {
namespace {

constexpr double kFont_pt = 10.0;
constexpr QSizeF kPictureRoom(600.0, 800.0);  // of A4 without margins, at the 96 dots per inch of a document
constexpr double kPictureDensity = 3.0;       // pixels in each of those
constexpr double kCellPadding = 6.0;
constexpr double kToWrite = 52.0;  // width of a column to write in
constexpr const char* kToWriteIn = "table.facts th, table.facts td { border: 1px solid #63646a; }";
// All steps of a lesson at once, where the window shows one; it takes about a second at most.
constexpr page::PageLimits kStrangersPaper{std::size_t{128} << 10, 8000};

/// Reads its pictures itself, at once and as finely as paper shows them.
class PaperDocument : public QTextDocument {
 public:
  explicit PaperDocument(const PaperPage& page) : page_(page) {
    const QByteArray text = page.markdown.toUtf8();
    QFont font = QApplication::font();
    font.setPointSizeF(kFont_pt);
    setDefaultFont(font);
    setDefaultStyleSheet(QString::fromStdString(page::pageStyle(page::lightColours())) +
                         (page.is_worksheets ? kToWriteIn : ""));
    setMetaInformation(QTextDocument::DocumentTitle, page.title);
    const page::Page read = page::readPage({text.data(), static_cast<std::size_t>(text.size())}, {}, {},
                                           page.author == Author::Program ? page::PageLimits{} : kStrangersPaper);
    setHtml(QString::fromStdString(read.html) + sentenceText(read.cut).toHtmlEscaped());
    if (page.is_worksheets) makeSheets();
  }

 protected:
  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::ImageResource || !name.isRelative()) return QByteArray("");
    const std::string folder = page_.folder.toStdString();
    const std::string within = page_.author == Author::Program ? folder + "/.." : folder;
    const Result<QImage> read =
        readPagePicture({within, folder + "/" + name.path().toStdString()}, (kPictureRoom * kPictureDensity).toSize());
    if (!read) return QByteArray("");
    QImage image = read.value();
    image.setDevicePixelRatio(
        std::max({1.0, image.width() / kPictureRoom.width(), image.height() / kPictureRoom.height()}));
    return image;
  }

 private:
  void makeSheets() {
    int first = -1;  // where the first sheet begins
    for (QTextBlock block = begin(); block.isValid(); block = block.next()) {
      QTextBlockFormat format = block.blockFormat();
      if (format.headingLevel() != 2) continue;
      if (first < 0) first = block.position();
      format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
      QTextCursor(block).setBlockFormat(format);
    }
    for (QTextFrame* const frame : rootFrame()->childFrames()) {
      auto* const table = qobject_cast<QTextTable*>(frame);
      if (table == nullptr || table->firstPosition() < first) continue;
      QTextTableFormat format = table->format();
      QList<QTextLength> widths(table->columns(), QTextLength(QTextLength::FixedLength, kToWrite));
      widths[0] = QTextLength();
      format.setColumnWidthConstraints(widths);
      format.setCellPadding(kCellPadding);
      table->setFormat(format);
    }
  }

  const PaperPage& page_;
};

QPageSize::PageSizeId paper() {
  return QLocale().measurementSystem() == QLocale::ImperialUSSystem ? QPageSize::Letter : QPageSize::A4;
}

}  // namespace

Problems savePdf(const PaperPage& page, const QString& path) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(paper()));
    writer.setPageMargins(QMarginsF());  // the document has margins of its own
    writer.setTitle(page.title);
    PaperDocument(page).print(&writer);
  }
  QSaveFile file(path);
  if (file.open(QIODevice::WriteOnly) && file.write(buffer.data()) == buffer.size() && file.commit()) return {};
  return {{phrase(QT_TRANSLATE_NOOP("problem", "The file cannot be written: %1. Choose another folder."),
                  {file.errorString().toStdString()}),
           {path.toStdString()}}};
}

void askToPrint(QWidget* window, const QString& name, const PaperPage& page) {
  auto* const dialog = new QPrintDialog(window);
  dialog->setObjectName(QString("dialog.%1_print").arg(name));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setOption(QAbstractPrintDialog::PrintSelection, false);
  QPrinter& printer = *dialog->printer();
  printer.setDocName(page.title);
  printer.setFullPage(true);
  QObject::connect(dialog, qOverload<QPrinter*>(&QPrintDialog::accepted), dialog,
                   [page](QPrinter* chosen) { PaperDocument(page).print(chosen); });
  dialog->open();
}

void askToSavePdf(QWidget* window, const QString& name, const PaperPage& page,
                  std::function<void(const QString& path)> saved) {
  const QByteArray dialog = QString("dialog.%1_pdf").arg(name).toUtf8();
  askWhereToSave(window, dialog.constData(), tr("Save as PDF"), fileNameOf(page.title) + ".pdf", tr("PDF (*.pdf)"),
                 [window, dialog, page, saved = std::move(saved)](const QString& path) {
                   const Problems problems = savePdf(page, path);
                   if (problems.empty()) return saved(path);
                   showProblemsBox(dialog + "_problems", tr("Save as PDF"), tr("The page was not saved."), problems,
                                   window);
                 });
}

}  // namespace underact::gui
