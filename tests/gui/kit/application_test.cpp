#include "app/gui/kit/application.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <stdexcept>

namespace underact::gui::test {

TEST(Application, AnExceptionInAnEventIsToldAndTheProgramGoesOn) {
  class Throwing : public QObject {
    bool event(QEvent* event) override {
      if (event->type() == QEvent::User) throw std::runtime_error("a bad day");
      return QObject::event(event);
    }
  } throwing;
  std::string told;
  Application::onException([&told](const std::string& what) {
    told = what;
    throw std::runtime_error("and a worse one");  // from telling: ends nothing either
  });
  QEvent event(QEvent::User);
  EXPECT_FALSE(QCoreApplication::sendEvent(&throwing, &event));
  EXPECT_EQ(told, "a bad day");
  Application::onException({});
  EXPECT_FALSE(QCoreApplication::sendEvent(&throwing, &event));
}

}  // namespace underact::gui::test
