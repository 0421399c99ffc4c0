#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "core/json/json.h"
#include "tests/stories/story.h"
#include "tests/support/udp_listener.h"

namespace underact::gui::test {
namespace {

using underact::test::UdpListener;

QString addressOf(const UdpListener& listener) {
  return QString("127.0.0.1:%1").arg(listener.port());
}

int waiting(const UdpListener& listener) {
  int messages = 0;
  while (!listener.nextNow().empty()) ++messages;
  return messages;
}

bool isSending(Story& story) {
  return story.window().actions().find("live.send")->isChecked();
}

}  // namespace

TEST(StreamStory, EveryTickGoesOutWhileItIsOnAndNoneWhenItIsOffAgain) {
  const UdpListener listener;
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("live.address", addressOf(listener)));
  EXPECT_TRUE(isSending(story));
  story.perform("session.start");
  story.run(50);
  const Result<json::Value> first = json::parse(listener.next(), "message");
  ASSERT_TRUE(first);
  ASSERT_NE(first.value().find("q1_rad"), nullptr);
  ASSERT_NE(first.value().find("tick"), nullptr);
  int last_tick = static_cast<int>(first.value().find("tick")->number);
  for (int message = 1; message < 50; ++message) {
    const Result<json::Value> next = json::parse(listener.next(), "message");
    ASSERT_TRUE(next);
    EXPECT_EQ(next.value().find("tick")->number, ++last_tick);
  }
  EXPECT_EQ(waiting(listener), 0);
  story.perform("live.send", false);
  story.run(50);
  EXPECT_EQ(waiting(listener), 0);
  story.perform("live.send", true);  // to where it went before
  story.run(50);
  EXPECT_EQ(waiting(listener), 50);
}

TEST(StreamStory, TheStatusLineSaysThatItSendsAndWhere) {
  Story story("02_sphere", {.size = {1024, 700}});
  auto* live = story.find<QLabel>("status.live");
  EXPECT_FALSE(isSending(story));
  EXPECT_FALSE(live->isVisible());
  story.perform("live.send", true);
  story.run(10);
  EXPECT_TRUE(live->isVisible());
  EXPECT_EQ(live->text(), "live data to 127.0.0.1:9870");
  EXPECT_TRUE(live->toolTip().startsWith("10 ticks sent")) << live->toolTip().toStdString();
  story.settle();
  for (const char* name : {"status.live", "status.force"}) {
    QWidget* field = story.find(name);
    EXPECT_GE(field->width(), field->minimumSizeHint().width()) << name << " is cut";
    const QRect there(field->mapTo(&story.window(), QPoint()), field->size());
    EXPECT_TRUE(story.window().rect().contains(there)) << name;
  }
  EXPECT_TRUE(story.picture().save(QString(UNDERACT_BINARY) + "/pictures/window_live.png"));
  story.perform("live.send", false);
  story.run(10);
  EXPECT_FALSE(live->isVisible());
}

TEST(StreamStory, ItIsOffAndOfThisMachineAtEachStart) {
  const UdpListener listener;
  {
    Story story("02_sphere");
    ASSERT_TRUE(story.perform("live.address", addressOf(listener)));
  }
  Story story("02_sphere", {.first_start = false});
  EXPECT_FALSE(isSending(story));
  story.perform("live.send", true);
  story.run(1);
  EXPECT_EQ(story.find<QLabel>("status.live")->text(), "live data to 127.0.0.1:9870");
  EXPECT_EQ(waiting(listener), 0);
}

TEST(StreamStory, TheDialogWarnsOfAnotherMachineAndRefusesWhatIsNoAddress) {
  const UdpListener listener;
  Story story("02_sphere");
  story.perform("live.address");
  auto* dialog = story.find("dialog.live");
  auto* address = story.find<QLineEdit>("dialog.live.address");
  auto* warning = story.find<QLabel>("dialog.live.warning");
  auto* refusal = story.find<QLabel>("dialog.live.refusal");
  story.bringToFront(dialog);
  EXPECT_EQ(address->text(), "127.0.0.1:9870");
  EXPECT_FALSE(warning->isVisible());
  story.type(address, "lab");
  EXPECT_TRUE(refusal->isVisible());
  EXPECT_TRUE(refusal->text().contains("is not an address"));
  EXPECT_FALSE(isSending(story));
  address->setText("192.168.1.20");
  EXPECT_FALSE(refusal->isVisible());
  EXPECT_TRUE(warning->isVisible());
  EXPECT_TRUE(warning->text().contains("not this machine"));
  story.settle();
  EXPECT_TRUE(dialog->grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/dialog_live.png"));
  address->setText(addressOf(listener));
  EXPECT_FALSE(warning->isVisible());
  story.key(Qt::Key_Return);
  EXPECT_TRUE(isSending(story));
  story.run(3);
  EXPECT_EQ(waiting(listener), 3);
}

}  // namespace underact::gui::test
