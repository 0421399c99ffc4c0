#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QMenu>
#include <QTemporaryDir>
#include <QToolButton>

#include "app/gui/service/live_service.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow serviceFeature();
}

namespace underact::gui::test {
namespace {

/// A desk whose tokens are in a folder of its own.
struct ServiceDesk {
  ServiceDesk() {
    qputenv("XDG_RUNTIME_DIR", folder.path().toUtf8());
    desk = std::make_unique<Desk>(serviceFeature());
    live = &desk->listener<LiveService>();
  }
  QStringList entries() {
    auto* menu = desk->find<QMenu>("menu.service");
    emit menu->aboutToShow();
    QStringList texts;
    for (const QAction* action : menu->actions())
      if (!action->isSeparator()) texts << action->text();
    return texts;
  }
  QTemporaryDir folder;
  std::unique_ptr<Desk> desk;
  LiveService* live = nullptr;
};

}  // namespace

TEST(LiveService, ListensOnlyWhileItIsOnAndTheTokensFileGoesWithIt) {
  ServiceDesk one;
  EXPECT_FALSE(one.live->isOn());
  EXPECT_FALSE(one.desk->actions().find("service.take_back")->isEnabled());
  EXPECT_FALSE(one.desk->perform("service.take_back", true));
  ASSERT_TRUE(one.desk->perform("service.on", true));
  EXPECT_TRUE(one.desk->actions().find("service.take_back")->isEnabled());
  EXPECT_EQ(one.live->address(), QString("ws://127.0.0.1:%1").arg(one.live->port()));
  const QString token = one.live->tokenFile();
  EXPECT_TRUE(QFile::exists(token)) << token.toStdString();
  ASSERT_TRUE(one.desk->perform("service.on", false));
  EXPECT_FALSE(one.live->isOn());
  EXPECT_FALSE(QFile::exists(token));
  EXPECT_EQ(one.live->address(), QString());
}

TEST(LiveService, ASecondWindowTakesAFreePort) {
  ServiceDesk one;
  ASSERT_TRUE(one.desk->perform("service.on", true));
  ServiceDesk other;
  ASSERT_TRUE(other.desk->perform("service.on", true));
  EXPECT_NE(one.live->port(), other.live->port());
  EXPECT_NE(other.live->port(), 0);
}

TEST(LiveService, ItsMenuNamesWhoIsThereAndCopiesWhatTheyNeed) {
  ServiceDesk one;
  ASSERT_TRUE(one.desk->perform("service.on", true));
  serve::Service& service = *one.live->service();
  QFile file(one.live->tokenFile());
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const std::string token = file.readAll().trimmed().toStdString();
  const int client = service.connect();
  service.receive(client, {R"({"id": 1, "do": "hello", "name": "trials", "token": ")" + token + "\"}"}, 0.0);
  service.receive(client, {R"({"id": 2, "do": "lease", "lease": "take"})"}, 0.0);
  const int listener = service.connect();
  service.receive(listener, {R"({"id": 1, "do": "hello", "name": "plot", "token": ")" + token + "\"}"}, 0.0);
  EXPECT_EQ(one.entries().mid(2, 2), QStringList({"trials steers", "plot listens"}));
  one.desk->frame();
  EXPECT_EQ(one.desk->find<QToolButton>("status.service")->text(), "trials steers");
  ASSERT_TRUE(one.desk->perform("service.take_back", true));
  EXPECT_EQ(one.entries().mid(2, 2), QStringList({"trials listens", "plot listens"}));
  one.desk->find<QMenu>("menu.service")->actions().first()->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), one.live->address());
  one.desk->find<QMenu>("menu.service")->actions().at(1)->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), one.live->tokenFile());
}

}  // namespace underact::gui::test
