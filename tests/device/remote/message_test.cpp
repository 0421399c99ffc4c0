#include "device/remote/message.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/arm/preset.h"

namespace underact::device::remote {
namespace {

const arm::Geometry kGeometry{0.13335, 0.13335, Vec3(0.0, -0.11, -0.035)};

std::vector<Message> oneOfEach() {
  SampleMessage sample;
  sample.sequence = 0x0102030405060708ULL;
  sample.sample = {-5, {0.1, -0.2, 0.3, -0.4, 0.5, -0.0}, 3, 7};
  sample.has_sample = true;
  return {sample,
          ForceMessage{9, 8, Vec3(0.1, -0.2, 0.3), true},
          Hello{77, 1000, true, {"omni-thesis", kGeometry}},
          Welcome{4000, true, false, true, 0.88, 0.5, {"omni-thesis", kGeometry}, "Simulated arm"},
          Words{About::Trouble, "Plug it in."},
          Bye{}};
}

}  // namespace

TEST(RemoteMessage, EachComesBackAsItWas) {
  for (const Message& message : oneOfEach()) {
    const std::vector<std::uint8_t> bytes = bytesOf(message);
    EXPECT_LE(bytes.size(), kLongestMessage);
    const std::optional<Message> read = readMessage(bytes);
    ASSERT_TRUE(read) << message.index();
    EXPECT_EQ(read->index(), message.index());
    EXPECT_EQ(bytesOf(*read), bytes) << message.index();
  }
  const auto force = std::get<ForceMessage>(*readMessage(bytesOf(oneOfEach()[1])));
  EXPECT_EQ(force.number, 9U);
  EXPECT_EQ(force.answered, 8U);
  EXPECT_EQ(force.f_T_W, Vec3(0.1, -0.2, 0.3));
  EXPECT_TRUE(force.pushes);
}

// What another program would have to write, byte by byte.
TEST(RemoteMessage, IsLaidOutAsTheGuideSays) {
  const std::vector<std::uint8_t> force = bytesOf(oneOfEach()[1]);
  ASSERT_EQ(force.size(), kForceBytes);
  EXPECT_EQ((std::vector<std::uint8_t>{'U', 'A', 'R', 'M', 1, 0, 2, 0}),
            (std::vector<std::uint8_t>(force.begin(), force.begin() + 8)));
  EXPECT_EQ(force[8], 9);
  EXPECT_EQ(force[16], 8);
  const std::vector<std::uint8_t> tenth{0x9A, 0x99, 0x99, 0x99, 0x99, 0x99, 0xB9, 0x3F};  // 0.1
  EXPECT_EQ(tenth, (std::vector<std::uint8_t>(force.begin() + 24, force.begin() + 32)));
  EXPECT_EQ(force[48], 1);
  const std::vector<std::uint8_t> sample = bytesOf(oneOfEach()[0]);
  ASSERT_EQ(sample.size(), kSampleBytes);
  EXPECT_EQ(sample[8], 8);
  EXPECT_EQ(sample[15], 1);
  EXPECT_EQ(sample[16], 0xFB);  // -5
}

TEST(RemoteMessage, NoPartOfOneIsOneNorOneWithMore) {
  for (const Message& message : oneOfEach()) {
    std::vector<std::uint8_t> bytes = bytesOf(message);
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_FALSE(readMessage(std::span(bytes).first(size))) << message.index() << ", " << size;
    bytes.push_back(0);
    EXPECT_FALSE(readMessage(bytes)) << message.index();
  }
}

TEST(RemoteMessage, RefusesNaNsAndUnknownFlags) {
  std::vector<std::uint8_t> force = bytesOf(ForceMessage{1, 1, Vec3(0.0, std::nan(""), 0.0), true});
  EXPECT_FALSE(readMessage(force));
  force = bytesOf(ForceMessage{1, 1, Vec3(0.0, kInfinity, 0.0), true});
  EXPECT_FALSE(readMessage(force));
  force = bytesOf(oneOfEach()[1]);
  force[48] = 2;
  EXPECT_FALSE(readMessage(force));
  std::vector<std::uint8_t> words = bytesOf(oneOfEach()[4]);
  words[8] = 5;  // about something nobody knows
  EXPECT_FALSE(readMessage(words));
  words = bytesOf(oneOfEach()[4]);
  words.back() = 0x1B;  // what could move a terminal's cursor
  EXPECT_FALSE(readMessage(words));
}

TEST(RemoteMessage, AnotherVersionIsToldFromWhatIsNone) {
  std::vector<std::uint8_t> bytes = bytesOf(Bye{});
  bytes[4] = 2;
  EXPECT_FALSE(readMessage(bytes));
  EXPECT_EQ(versionOf(bytes), 2);
  bytes[0] = 'X';
  EXPECT_EQ(versionOf(bytes), std::nullopt);
  EXPECT_EQ(versionOf({}), std::nullopt);
}

TEST(RemoteMessage, ATextIsCutAndCleaned) {
  const auto read = readMessage(bytesOf(Words{About::Refusal, std::string(2000, 'a') + "\n"}));
  ASSERT_TRUE(read);
  EXPECT_EQ(std::get<Words>(*read).text, std::string(kLongestText, 'a'));
  EXPECT_EQ(std::get<Words>(*readMessage(bytesOf(Words{About::Refusal, "a\nb"}))).text, "a b");
}

}  // namespace underact::device::remote
