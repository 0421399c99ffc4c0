#include "app/gui/kit/application.h"

#include <QEvent>
#include <QLabel>
#include <QWizard>
#include <cstdio>
#include <exception>

#include "app/gui/kit/fit_screen.h"
#include "core/base/printed.h"

namespace underact::gui {
namespace {

/// What a label says is text, also where it looks like HTML: a name out of a file would otherwise be a page that Qt
/// loads files for. Tool tips, message boxes and the pages of wizards show their words in labels of their own. A label
/// is polished before its text is first measured or painted. Rich text must be asked for by setTextFormat().
void makePlain(QObject* receiver) {
  auto* const label = qobject_cast<QLabel*>(receiver);
  if (label != nullptr && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
  if (auto* const wizard = qobject_cast<QWizard*>(receiver)) {  // it sets the format of its labels with each page
    wizard->setTitleFormat(Qt::PlainText);
    wizard->setSubTitleFormat(Qt::PlainText);
  }
}

}  // namespace

bool Application::notify(QObject* receiver, QEvent* event) {
  try {
    if (event->type() == QEvent::Polish) makePlain(receiver);
    if (event->type() == QEvent::Show && !event->spontaneous() && receiver->isWidgetType())
      fitToScreen(*static_cast<QWidget*>(receiver));
    return QApplication::notify(receiver, event);
  } catch (const std::exception& exception) {
    tell(exception.what());
  } catch (...) {
    tell("an exception without a message");
  }
  return false;
}

void Application::onException(Tell tell) {
  auto* application = dynamic_cast<Application*>(QCoreApplication::instance());
  if (application != nullptr) application->tell_ = std::move(tell);
}

void Application::tell(const std::string& what) noexcept {
  std::fprintf(stderr, "An exception in the window: %s\n", printed(what).c_str());
  if (telling_ || !tell_) return;
  telling_ = true;
  try {
    tell_(what);
  } catch (...) {  // the listener stops the servo first; nothing else can be done
  }
  telling_ = false;
}

}  // namespace underact::gui
