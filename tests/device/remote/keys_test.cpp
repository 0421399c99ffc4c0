#include "device/remote/keys.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "tests/support/scratch_folder.h"

namespace underact::device::remote {
namespace {

Address addressOf(const std::string& text) {
  const Result<Address> address = readAddress(text);
  EXPECT_TRUE(address) << text;
  return address ? address.value() : Address{};
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST(RemoteAddress, IsAHostAPortBothOrNone) {
  EXPECT_EQ(addressOf("").text(), "127.0.0.1:7878");
  EXPECT_EQ(addressOf("arm-pc").text(), "arm-pc:7878");
  EXPECT_EQ(addressOf("192.168.1.20:80").text(), "192.168.1.20:80");
  EXPECT_EQ(addressOf(":80").text(), "127.0.0.1:80");
  EXPECT_EQ(addressOf("[fe80::1]:80").text(), "[fe80::1]:80");
  EXPECT_EQ(addressOf("[::1]").text(), "[::1]:7878");
  EXPECT_TRUE(addressOf("[::1]").isThisMachine());
  EXPECT_TRUE(addressOf("localhost").isThisMachine());
  EXPECT_TRUE(addressOf("127.0.0.2").isThisMachine());
  EXPECT_FALSE(addressOf("0.0.0.0").isThisMachine());
  EXPECT_FALSE(addressOf("127.example.org").isThisMachine());
  for (const char* const wrong : {"a b", "host:", "host:x", "host:70000", "host:-1", "::1", "[::1", "[::1]x", "[]:1",
                                  "-x", "a/b", "host:80;ipc", "tcp://a", "h\n:1", "host:80 "})
    EXPECT_FALSE(readAddress(wrong)) << wrong;
}

TEST(RemoteKeys, AreMadeOnceAndForTheirUserAlone) {
  const test::ScratchFolder scratch;
  const KeyFolder folder(scratch.path() + "/new/keys");
  EXPECT_FALSE(folder.hasOwn());
  const Result<KeyPair> made = folder.own();
  ASSERT_TRUE(made);
  EXPECT_TRUE(isKey(made.value().public_key));
  EXPECT_TRUE(isKey(made.value().secret_key));
  EXPECT_NE(made.value().public_key, made.value().secret_key);
  struct stat status {};
  ASSERT_EQ(::stat((folder.path() / "arm_key").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  EXPECT_EQ(folder.own().value().secret_key, made.value().secret_key);
  EXPECT_NE(folder.makeNew().value().public_key, made.value().public_key);
  EXPECT_NE(folder.own().value().public_key, made.value().public_key);
}

TEST(RemoteKeys, AreNotUsedWhereOthersMayReadThem) {
  const test::ScratchFolder scratch;
  const KeyFolder folder(scratch.path());
  ASSERT_TRUE(folder.own());
  ASSERT_EQ(::chmod(scratch.file("arm_key").c_str(), 0644), 0);
  const Result<KeyPair> own = folder.own();
  ASSERT_FALSE(own);
  EXPECT_NE(own.problems().front().sentence.find("chmod 600"), std::string::npos);
}

TEST(RemoteKeys, OfOthersInAFileThatOthersMayReadOrWriteAreNotUsed) {
  const test::ScratchFolder scratch;
  const KeyFolder folder(scratch.path()), other(scratch.path() + "/other");
  const std::string anna = other.own().value().public_key;
  ASSERT_TRUE(folder.own());
  ASSERT_TRUE(folder.allow(anna, "Anna").empty());
  ASSERT_TRUE(folder.trust(addressOf("arm-pc"), anna).empty());
  for (const unsigned mode : {0640U, 0620U, 0604U, 0602U, 0666U}) {
    ASSERT_EQ(::chmod(scratch.file("arm_clients").c_str(), mode), 0);
    ASSERT_EQ(::chmod(scratch.file("arm_hosts").c_str(), mode), 0);
    const auto clients = folder.clients();
    ASSERT_FALSE(clients) << mode;
    EXPECT_EQ(clients.problems().front().sentence.find("Others may read or change who may use your arm. Run chmod 600"),
              0U)
        << clients.problems().front().sentence;
    EXPECT_FALSE(folder.allow(folder.own().value().public_key, "").empty())
        << "what others wrote would pass for one's own";
    EXPECT_FALSE(folder.keyOf(addressOf("arm-pc")));
    EXPECT_FALSE(folder.trust(addressOf("other-pc"), anna).empty());
  }
  ASSERT_EQ(::chmod(scratch.file("arm_clients").c_str(), 0600), 0);
  EXPECT_EQ(folder.clients().value(), std::vector<std::string>{anna});
}

TEST(RemoteKeys, OfAnotherUsersFileAreNotUsed) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can make a file of another user's";
  const test::ScratchFolder scratch;
  const KeyFolder folder(scratch.path());
  ASSERT_TRUE(folder.allow(KeyFolder(scratch.path() + "/other").own().value().public_key, "").empty());
  ASSERT_EQ(::chown(scratch.file("arm_clients").c_str(), 65534, 65534), 0);
  const auto clients = folder.clients();
  ASSERT_FALSE(clients);
  EXPECT_NE(clients.problems().front().sentence.find("another user"), std::string::npos);
}

TEST(RemoteKeys, InAPipeOrAnEndlessFileAreNotWaitedFor) {
  const test::ScratchFolder scratch;
  const KeyFolder folder(scratch.path());
  ASSERT_EQ(::mkfifo(scratch.file("arm_clients").c_str(), 0600), 0);
  EXPECT_FALSE(folder.clients());
  ASSERT_EQ(::symlink("/dev/zero", scratch.file("arm_hosts").c_str()), 0);
  EXPECT_FALSE(folder.keyOf(addressOf("arm-pc")));
}

TEST(RemoteKeys, FilesThatAreNoneAreRefusedWithTheirPlace) {
  const test::ScratchFolder scratch;
  const KeyFolder folder(scratch.path());
  const mode_t before = ::umask(0077);
  scratch.write("arm_key", "hello\n");
  EXPECT_FALSE(folder.own());
  scratch.write("arm_clients", std::string(40, 'a') + " Anna\nhello\n");
  const auto clients = folder.clients();
  ASSERT_FALSE(clients);
  EXPECT_EQ(clients.problems().front().place.line, 2);
  scratch.write("arm_hosts", "arm-pc:7878 hello\n");
  ::umask(before);
  EXPECT_FALSE(folder.keyOf(addressOf("arm-pc")));
  EXPECT_FALSE(folder.allow("hello", "Anna").empty());
  EXPECT_FALSE(folder.trust(addressOf("arm-pc"), "hello").empty());
  for (const char bad : {'\'', '"', ' ', '~', '\\', '\n'}) EXPECT_FALSE(isKey(std::string(39, 'a') + bad)) << bad;
}

TEST(RemoteKeys, OfOthersAreNotedOnceEach) {
  const test::ScratchFolder scratch;
  const KeyFolder folder(scratch.path()), other(scratch.path() + "/other"), third(scratch.path() + "/third");
  const std::string anna = other.own().value().public_key, ben = third.own().value().public_key;
  EXPECT_TRUE(folder.clients().value().empty());
  EXPECT_TRUE(folder.allow(anna, "Anna's laptop").empty());
  EXPECT_TRUE(folder.allow(ben, "").empty());
  EXPECT_TRUE(folder.allow(anna, "again").empty());
  EXPECT_EQ(folder.clients().value(), (std::vector<std::string>{anna, ben}));
  EXPECT_EQ(contentOf(scratch.file("arm_clients")), anna + " Anna's laptop\n" + ben + "\n");

  EXPECT_EQ(folder.keyOf(addressOf("arm-pc")).value(), "");
  EXPECT_EQ(folder.keyOf(addressOf("")).value(), folder.own().value().public_key) << "one's own, at this machine";
  EXPECT_TRUE(folder.trust(addressOf("arm-pc"), anna).empty());
  EXPECT_TRUE(folder.trust(addressOf("127.0.0.1:9000"), anna).empty());
  EXPECT_TRUE(folder.trust(addressOf("arm-pc:7878"), ben).empty());
  EXPECT_EQ(folder.keyOf(addressOf("arm-pc")).value(), ben);
  EXPECT_EQ(folder.keyOf(addressOf("arm-pc:7879")).value(), "");
  EXPECT_EQ(folder.keyOf(addressOf("127.0.0.1:9000")).value(), anna);
}

}  // namespace underact::device::remote
