#include "app/stream/live_stream.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

#include "core/json/json.h"
#include "tests/support/udp_listener.h"

namespace underact::stream {
TEST(LiveStream, SendsEachTickAsOneJsonObjectWithoutWhatIsNoNumber) {
  const test::UdpListener listener;
  Result<LiveStream> live = LiveStream::open({kThisMachine, listener.port()}, 1000);
  ASSERT_TRUE(live);
  servo::TickRecord record;
  record.tick = 7;
  record.time_ns = 7'000'000;
  record.f_sent_T_W = Vec3(0.1, -0.25, 1e-300);
  record.p_WP.setConstant(kNotANumber);
  live.value().send(record);
  const Result<json::Value> message = json::parse(listener.next(), "message");
  ASSERT_TRUE(message);
  EXPECT_EQ(message.value().find("timestamp")->number, 0.007);
  EXPECT_EQ(message.value().find("tick")->number, 7);
  EXPECT_EQ(message.value().find("force_sent_y_N")->number, -0.25);
  EXPECT_EQ(message.value().find("fault")->text, "none");
  EXPECT_EQ(message.value().find("target_x_mm"), nullptr);
  EXPECT_EQ(live.value().sent(), 1);
}

TEST(LiveStream, OfAFastServoSendsAThousandMessagesASecond) {
  const test::UdpListener listener;
  Result<LiveStream> live = LiveStream::open({kThisMachine, listener.port()}, 4000);
  ASSERT_TRUE(live);
  servo::TickRecord record;
  for (record.tick = 1; record.tick <= 100; ++record.tick) live.value().send(record);
  EXPECT_EQ(live.value().sent(), 25);
  EXPECT_NE(listener.next().find("\"tick\":4,"), std::string::npos);
  live.value().setRate(500);  // of a slow one every tick goes out
  for (; record.tick <= 110; ++record.tick) live.value().send(record);
  EXPECT_EQ(live.value().sent(), 25 + 10);
}

TEST(LiveStream, SaysItsVersionTheSessionAndTheClocks) {
  const test::UdpListener listener;
  Result<LiveStream> live = LiveStream::open({kThisMachine, listener.port()}, 1000);
  ASSERT_TRUE(live);
  live.value().send({});
  live.value().setSession("0123456789abcdef");
  live.value().send({});
  const Result<json::Value> first = json::parse(listener.next(), "message"), second = json::parse(listener.next(), "m");
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first.value().find("underact_live")->number, kLiveVersion);
  EXPECT_EQ(first.value().find("session"), nullptr);
  EXPECT_EQ(second.value().find("session")->text, "0123456789abcdef");
  EXPECT_EQ(second.value().find("clock")->text, "arm");
  EXPECT_GT(second.value().find("unix_s")->number, 1.5e9);
}

// A receiver with the usual buffer, which takes what comes in its own time.
TEST(LiveStream, LosesNothingWhereTicksComeFasterThanRealTimeAndItIsPaced) {
  const test::UdpListener listener;
  Result<LiveStream> live = LiveStream::open({kThisMachine, listener.port()}, 1000);
  ASSERT_TRUE(live);
  live.value().pace();
  constexpr int kTicks = 4000;
  std::atomic<bool> ended{false};
  int came = 0;
  std::thread receiver([&] {
    while (!ended || came < kTicks) {
      if (listener.next().empty()) return;
      ++came;
    }
  });
  servo::TickRecord record;
  for (record.tick = 1; record.tick <= kTicks; ++record.tick) live.value().send(record);
  ended = true;
  receiver.join();
  EXPECT_EQ(came, kTicks);
  EXPECT_EQ(live.value().sent(), kTicks);
}

TEST(LiveStream, GoesOnWhereNobodyListens) {
  Result<LiveStream> live = LiveStream::open({kThisMachine, 9}, 1000);
  ASSERT_TRUE(live);
  for (int tick = 0; tick < 100; ++tick) live.value().send({});
  EXPECT_EQ(live.value().sent() + live.value().lost(), 100);
}

TEST(Address, IsReadInEveryForm) {
  EXPECT_EQ(readAddress("9871").value().port, 9871);
  EXPECT_EQ(readAddress("9871").value().host, "127.0.0.1");
  EXPECT_EQ(readAddress("192.168.1.20").value().port, kPort);
  EXPECT_EQ(readAddress("192.168.1.20:99").value().port, 99);
  EXPECT_EQ(readAddress("[::1]:99").value().host, "::1");
  EXPECT_TRUE(readAddress("[::1]").value().isThisMachine());
  EXPECT_FALSE(readAddress("192.168.1.20").value().isThisMachine());
  for (const char* wrong : {"", "lab", "70000", "0", "1.2.3.4:", "1.2.3.4:x", "[::1", "1.2.3.4.5"}) {
    EXPECT_FALSE(readAddress(wrong)) << wrong;
  }
}

}  // namespace underact::stream
