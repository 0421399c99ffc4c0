#include "app/gui/help/help_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/words.h"
#include "underact/version.h"

namespace underact::gui {
namespace {

QString row(const QString& what, const QString& does) {
  return QString("<tr><td style='padding-right:24px'><b>%1</b></td><td>%2</td></tr>")
      .arg(what.toHtmlEscaped(), does.toHtmlEscaped());
}

QString handTable() {
  return "<table cellspacing='4'>" +
         row(QObject::tr("Drag the stylus"),
             QObject::tr(
                 "moves the simulated hand in the plane of the view; when you release it, the hand lets go, unless "
                 "Keep holding (F6) is on")) +
         row(QObject::tr("Wheel while dragging"), QObject::tr("moves the hand nearer or further away")) +
         row(QObject::tr("Arrow keys"),
             QObject::tr("move the hand 2 mm, with Shift 10 mm (press F2 first, or click the view); it holds the "
                         "stylus until you let go (Shift+F6)")) +
         row(QObject::tr("Page Up, Page Down"), QObject::tr("move the hand in depth")) +
         row(QObject::tr("Ctrl and arrow keys"), QObject::tr("turn the stylus; its position then follows the scene")) +
         row(QObject::tr("Game controller, 3D mouse"),
             QObject::tr(
                 "move and rotate the simulated hand; the panel Input devices shows and edits their mappings")) +
         row(QObject::tr("Space"), QObject::tr("holds the stylus button down (press F2 first, or click the view)")) +
         row(QObject::tr("Rings o and p"), QObject::tr("in a scene with an influence factor: the point that the stylus "
                                                       "points at, and the point nearest to the tip")) +
         row(QObject::tr("Drag beside the stylus"), QObject::tr("rotates the view; with the middle button, pans it")) +
         row(QObject::tr("Wheel"), QObject::tr("zooms the view")) +
         row(QObject::tr("Sliders"), QObject::tr("respond to the mouse, the arrow keys and, once clicked, the wheel; a "
                                                 "double click restores the scene's value")) +
         row(QObject::tr("Table of joints"),
             QObject::tr("F2, a double click or typing edits a number; Enter applies it")) +
         "</table>";
}

QString keyTable(const Actions& actions) {
  QString table = "<table cellspacing='4'>";
  for (const QString& name : actions.names()) {
    const QAction* action = actions.find(name);
    if (action == nullptr || action->shortcut().isEmpty()) continue;
    table += row(action->shortcut().toString(QKeySequence::NativeText), action->statusTip());
  }
  table += row(QKeySequence("Shift+Esc").toString(QKeySequence::NativeText),
               QObject::tr("Stops the servo wherever you are, also in an open menu or dialog."));
  return table + "</table>";
}

void addCloseButton(QDialog* dialog, QVBoxLayout* column) {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QPushButton* close = buttons->button(QDialogButtonBox::Close);
  nameWidget(close, dialog->objectName() + ".close", QObject::tr("Close"));
  close->setIcon({});
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  column->addWidget(buttons);
}

}  // namespace

HelpDialog::HelpDialog(const Actions& actions, QWidget* parent) : QDialog(parent) {
  setObjectName("dialog.help");
  setWindowTitle(tr("Mouse and keys"));
  resize(640, 560);
  auto* page = new QTextBrowser(this);
  nameWidget(page, "dialog.help.page", tr("What the mouse and the keys do"));
  page->setHtml(QString("<p>%1</p><h3>%2</h3>%3<h3>%4</h3>%5")
                    .arg(tr("The view shows what the hand feels: the constraint in blue, the stylus, the target in "
                            "green and the force in orange. Start turns the force on; Stop and Esc turn it off."),
                         tr("The hand and the view"), handTable(), tr("Keys"), keyTable(actions)));
  auto* column = new QVBoxLayout(this);
  column->addWidget(page);
  addCloseButton(this, column);
}

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
  setObjectName("dialog.about");
  setWindowTitle(tr("About Underact"));
  auto* text = new QLabel(tr("<h3>Underact %1</h3>"
                             "<p>Feel geometry through a small haptic arm, and see what you feel.</p>"
                             "<p>Licence: BSD-3-Clause. Uses Qt %2 (LGPL) and VTK (BSD).</p>"
                             "<p>Tested in simulation only; no part of it has been tested on a real arm yet.</p>")
                              .arg(kVersion, qVersion()),
                          this);
  text->setTextFormat(Qt::RichText);
  nameWidget(text, "dialog.about.text", tr("About Underact"));
  text->setWordWrap(true);
  text->setMinimumWidth(380);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 12, 20, 16);
  column->addWidget(text);
  addCloseButton(this, column);
}

void addHelpActions(Actions& actions, QWidget* window) {
  const auto show = [](QDialog* dialog) {
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
    return true;
  };
  actions.add(
      {"help.keys", tr("&Mouse and keys"), QKeySequence("Shift+F1"), tr("Shows what the mouse and the keys do.")},
      [&actions, window, show](const QVariantList&) { return show(new HelpDialog(actions, window)); });
  actions.add({"help.about", tr("&About Underact"), QKeySequence("Ctrl+F1"),
               tr("Shows the version, the licence, and what has not been tested.")},
              [window, show](const QVariantList&) { return show(new AboutDialog(window)); });
}

}  // namespace underact::gui
