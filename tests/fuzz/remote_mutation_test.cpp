#include <gtest/gtest.h>

#include "device/remote/message.h"
#include "tests/fuzz/remote_judge.h"
#include "tests/support/property.h"

namespace underact::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> theMessages() {
  using namespace device::remote;
  const Kinematics arm{"omni-thesis", {0.13, 0.13, Vec3(0.0, -0.1, -0.03)}};
  return {bytesOf(SampleMessage{7, {1000, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, 1, 0}, true}),
          bytesOf(ForceMessage{8, 7, Vec3(0.1, 0.2, 0.3), true}),
          bytesOf(Hello{42, 1000, false, arm}),
          bytesOf(Welcome{1000, true, true, true, 0.88, 0.5, arm, "Double"}),
          bytesOf(Words{About::Refusal, "It is in use."}),
          bytesOf(Bye{})};
}

Bytes mutatedMessage(Random& random, const std::vector<Bytes>& messages) {
  Bytes bytes = messages[random.below(messages.size())];
  for (std::size_t count = 1 + random.below(3); count > 0; --count) {
    const std::size_t at = random.below(bytes.size() + 1);
    const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random.below(5)) {
      case 0:
        bytes.insert(place, static_cast<std::uint8_t>(random.bits()));
        break;
      case 1:
        bytes.erase(place,
                    place + static_cast<std::ptrdiff_t>(std::min<std::size_t>(bytes.size() - at, random.below(9))));
        break;
      case 2:
        if (at < bytes.size()) bytes[at] ^= static_cast<std::uint8_t>(1U << random.below(8));
        break;
      case 3:
        if (at < bytes.size()) bytes[at] = static_cast<std::uint8_t>(random.bits());
        break;
      default: {
        const Bytes& other = messages[random.below(messages.size())];
        bytes.insert(place, other.begin(), other.begin() + static_cast<std::ptrdiff_t>(random.below(other.size() + 1)));
      }
    }
  }
  return bytes;
}

TEST(RemoteMutations, EachIsRefusedOrIsTheOneWayToSaySo) {
  Random random(Seed{20261122});
  const std::vector<Bytes> messages = theMessages();
  const int count = sweep(200'000, 5'000'000);
  int read = 0;
  for (int i = 0; i < count; ++i) {
    const Bytes bytes = mutatedMessage(random, messages);
    ASSERT_EQ(judgeRemote(bytes), "") << "mutation " << i;
    read += device::remote::readMessage(bytes) ? 1 : 0;
  }
  // A mutator that only makes rubbish, or nothing new, would prove nothing.
  EXPECT_GT(read, count / 50);
  EXPECT_LT(read, count * 3 / 4);
}

TEST(RemoteMutations, WhateverComesIsJudged) {
  Random random(Seed{20261123});
  for (int i = 0; i < 20'000; ++i) {
    Bytes bytes(random.below(200));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
    ASSERT_EQ(judgeRemote(bytes), "");
  }
  EXPECT_EQ(judgeRemote(Bytes(1U << 22U, 'U')), "");
}

}  // namespace
}  // namespace underact::test
