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

/// Numbered lines of dots that came whole and in order, and those that were said to be left out.
struct Sum {
  int whole = 0, left_out = 0;
  int all() const { return whole + left_out; }
};

Sum sumOf(const std::string& text) {
  Sum sum;
  int last = -1;
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('(')) {
      sum.left_out += std::stoi(line.substr(1));
      continue;
    }
    const int number = std::stoi(line);
    EXPECT_GT(number, last);
    EXPECT_EQ(line, std::to_string(number) + std::string(100, '.'));
    last = number;
    ++sum.whole;
  }
  return sum;
}

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
  // Where the writer is slow to begin, lines are left out, and said to be, more than once.
  EXPECT_TRUE(test::comes([&] { return sumOf(pipe.read()).all() == 1000; })) << pipe.text;
  EXPECT_GE(sumOf(pipe.text).whole, static_cast<int>(Lines::kMax));
  EXPECT_GT(sumOf(pipe.text).left_out, 0);
  say("after");
  EXPECT_TRUE(test::comes([&] { return pipe.read().find("\nafter\n") != std::string::npos; }));
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
