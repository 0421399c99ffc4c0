#include "app/cli/lines.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <sstream>
#include <string>
#include <utility>

#include "tests/support/comes.h"

namespace underact::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// A pipe that holds 4096 bytes, and what has come out of it.
struct Pipe {
  Pipe() {
    EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
    ::fcntl(ends[1], F_SETPIPE_SZ, 4096);
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  }
  ~Pipe() {
    for (const int end : ends) ::close(end);
  }
  std::string read() {
    std::array<char, 4096> bytes{};
    for (ssize_t got = 0; (got = ::read(ends[0], bytes.data(), bytes.size())) > 0;)
      text.append(bytes.data(), static_cast<std::size_t>(got));
    return text;
  }
  std::array<int, 2> ends{-1, -1};
  std::string text;
};

}  // namespace

TEST(Lines, ComeWholeAndInOrder) {
  std::ostringstream out;
  {
    Lines say(out, -1);
    say("one");
    say("two");
  }
  EXPECT_EQ(out.str(), "one\ntwo\n");
}

TEST(Lines, NeverWaitForAReaderAndSayHowManyWereLeftOut) {
  std::ostringstream none;
  Pipe pipe;
  Lines say(none, pipe.ends[1]);
  const auto begin = Clock::now();
  for (int line = 0; line < 1000; ++line) say(std::to_string(line) + std::string(100, '.'));
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(10)) << "it would wait for ever";
  EXPECT_TRUE(test::comes([&] { return pipe.read().find("lines were left out") != std::string::npos; }));
  say("after");
  EXPECT_TRUE(test::comes([&] { return pipe.read().find("\nafter\n") != std::string::npos; }));
  std::istringstream text(pipe.text);
  int whole = 0, left_out = 0;
  for (std::string line; std::getline(text, line);) {
    if (line == std::to_string(whole) + std::string(100, '.')) ++whole;
    if (line[0] == '(') left_out = std::stoi(line.substr(1));
  }
  EXPECT_GE(whole, static_cast<int>(Lines::kMost));
  EXPECT_EQ(whole + left_out, 1000);
}

TEST(Lines, EndThoughNobodyReads) {
  std::ostringstream none;
  Pipe full, gone;
  {
    Lines say(none, full.ends[1]);
    for (int line = 0; line < 100; ++line) say(std::string(100, '.'));
  }
  ::close(std::exchange(gone.ends[0], -1));
  void (*const before)(int) = std::signal(SIGPIPE, SIG_IGN);
  {
    Lines say(none, gone.ends[1]);
    for (int line = 0; line < 10; ++line) say("for nobody");
  }
  std::signal(SIGPIPE, before);
}

}  // namespace underact::cli
