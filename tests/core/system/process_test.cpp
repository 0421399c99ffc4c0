#include "core/system/process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>

#include "core/system/channel.h"

namespace underact::system {
namespace {

/// What a shell says to a line.
std::string heardFrom(const std::string& line, std::vector<int> given = {}, bool is_apart = false) {
  const Pipe pipe = makePipe();
  given.resize(std::max<std::size_t>(given.size(), 2), -1);
  given[1] = pipe.writes.number();
  Process process({.program = "/bin/sh", .arguments = {"-c", line}, .given = given, .is_apart = is_apart});
  EXPECT_TRUE(process.waitForEnd(20'000)) << line;
  std::array<char, 4096> text{};
  const std::ptrdiff_t count =
      waitToRead(pipe.reads.number(), 0) ? readSome(pipe.reads.number(), std::as_writable_bytes(std::span(text))) : 0;
  return {text.data(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(count, 0))};
}

TEST(Process, HasWhatItIsGivenAndNothingElse) {
  const Pipe other = makePipe(), life = makePipe();
  Descriptor open_here(::dup(other.reads.number()));  // without close on exec
  EXPECT_EQ(heardFrom("readlink /proc/self/fd/0 /proc/self/fd/2"), "/dev/null\n/dev/null\n");
  EXPECT_EQ(heardFrom("for fd in 3 4 5 6 7 8 9 10 11 12; do [ -e /proc/$$/fd/$fd ] && echo $fd; done",
                      {-1, -1, -1, life.reads.number()}),
            "3\n");
}

TEST(Process, GetsEachDescriptorAtItsNumberInWhateverOrder) {
  const Pipe one = makePipe(), other = makePipe();
  writeSome(one.writes.number(), std::string_view("one\none\n"));
  writeSome(other.writes.number(), std::string_view("other\nother\n"));
  constexpr const char* kBoth = "read line <&3; echo $line; read line <&4; echo $line";
  EXPECT_EQ(heardFrom(kBoth, {-1, -1, -1, one.reads.number(), other.reads.number()}), "one\nother\n");
  EXPECT_EQ(heardFrom(kBoth, {-1, -1, -1, other.reads.number(), one.reads.number()}), "other\none\n");
}

TEST(Process, ThatIsApartHasASessionOfItsOwn) {
  constexpr const char* kSession = "cut -d ' ' -f 1,6 /proc/$$/stat";
  const std::string apart = heardFrom(kSession, {}, true), with_us = heardFrom(kSession);
  EXPECT_EQ(apart.substr(0, apart.find(' ')) + "\n", apart.substr(apart.find(' ') + 1));
  EXPECT_NE(with_us.substr(0, with_us.find(' ')) + "\n", with_us.substr(with_us.find(' ') + 1));
}

TEST(Process, SaysHowItEnded) {
  Process well({.program = "/bin/sh", .arguments = {"-c", "exit 7"}});
  ASSERT_TRUE(well.waitForEnd(20'000));
  EXPECT_FALSE(well.end().by_signal);
  EXPECT_EQ(well.end().code, 7);
  EXPECT_FALSE(well.runs());
  Process killed({.program = "/bin/sleep", .arguments = {"20"}});
  EXPECT_FALSE(killed.hasEnded());
  EXPECT_FALSE(killed.waitForEnd(20));
  killed.kill();
  ASSERT_TRUE(killed.waitForEnd(20'000));
  EXPECT_TRUE(killed.end().by_signal);
  EXPECT_EQ(killed.end().code, 9);
}

TEST(Process, DoesNotOutliveItsObject) {
  const Pipe pipe = makePipe();
  const auto start = std::chrono::steady_clock::now();
  { const Process process({.program = "/bin/sleep", .arguments = {"20"}, .given = {-1, pipe.writes.number()}}); }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Process, NamesTheReasonThatAProgramIsMissing) {
  Process none({.program = "/bin/there is no such program"});
  EXPECT_FALSE(none.runs());
  EXPECT_EQ(none.error(), ENOENT);
  EXPECT_TRUE(none.hasEnded());
}

TEST(RunHere, LeavesOneVariableOut) {
  ::setenv("UNDERACT_LEFT_OUT", "1", 1);
  ::setenv("UNDERACT_LEFT_OUT_NOT", "1", 1);
  const std::optional<End> end =
      runHere({"sh", "-c", "exit ${UNDERACT_LEFT_OUT:-4}${UNDERACT_LEFT_OUT_NOT}"}, "UNDERACT_LEFT_OUT");
  ::unsetenv("UNDERACT_LEFT_OUT");
  ::unsetenv("UNDERACT_LEFT_OUT_NOT");
  ASSERT_TRUE(end);
  EXPECT_EQ(end->code, 41);
  EXPECT_FALSE(runHere({"there is no such program"}, "PATH_OF_NONE"));
  EXPECT_EQ(errno, ENOENT);
}

}  // namespace
}  // namespace underact::system
