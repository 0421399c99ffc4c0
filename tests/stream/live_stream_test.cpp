#include "app/stream/live_stream.h"

#include <gtest/gtest.h>

#include <string>

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
