#include "app/gui/kit/application.h"

#include <cstdio>
#include <exception>

namespace underact::gui {

bool Application::notify(QObject* receiver, QEvent* event) {
  try {
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
  std::fprintf(stderr, "An exception in the window: %s\n", what.c_str());
  if (telling_ || !tell_) return;
  telling_ = true;
  try {
    tell_(what);
  } catch (...) {  // the listener stops the servo first; nothing else can be done
  }
  telling_ = false;
}

}  // namespace underact::gui
