#include <gtest/gtest.h>

#include <filesystem>

#include "core/system/signals.h"
#include "tests/cli/process.h"
#include "tests/cli/session.h"

namespace underact::test {
namespace {

using system::Interrupt;

/// What a signal does, left as it was.
class Disposition {
 public:
  Disposition(int signal, void (*handler)(int)) : signal_(signal), before_(std::signal(signal, handler)) {}
  ~Disposition() { std::signal(signal_, before_); }
  Disposition(const Disposition&) = delete;
  Disposition& operator=(const Disposition&) = delete;

 private:
  int signal_;
  void (*before_)(int);
};

void nothing(int /*signal*/) {}

}  // namespace

TEST(Interrupt, ComesByWhateverAsksAProgramToEnd) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt.came());
    std::raise(signal);
    EXPECT_TRUE(interrupt.came()) << signal;
  }
}

TEST(Interrupt, LeavesTheEndOfATerminalToWhoIgnoredIt) {  // nohup
  const Disposition ignored(SIGHUP, SIG_IGN);
  const Interrupt interrupt;
  std::raise(SIGHUP);
  EXPECT_FALSE(interrupt.came());
}

TEST(Interrupt, AReaderWhoMayGoEndsNothing) {
  const Interrupt interrupt(system::Reader::MayGo);
  std::raise(SIGPIPE);
  EXPECT_FALSE(interrupt.came());
}

TEST(Interrupt, LeavesAllAsItWas) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) {
    const Disposition own(signal, nothing);
    { const Interrupt interrupt(system::Reader::MayGo); }
    EXPECT_EQ(std::signal(signal, nothing), nothing) << signal;
  }
}

TEST(Interrupt, CountsUpInTheHandlerItselfWhateverTheThreadsDo) {
  std::atomic<std::uint64_t> stops = 0;
  const Interrupt early(system::Reader::MayGo);
  {
    const Interrupt interrupt(system::Reader::MayGo, &stops);
    std::raise(SIGTERM);
    EXPECT_EQ(stops, 1U);
    EXPECT_TRUE(early.came());
  }
  std::raise(SIGINT);
  EXPECT_EQ(stops, 1U) << "the counter may be gone";
  const Interrupt late(system::Reader::MayGo, &stops);
  EXPECT_TRUE(late.came()) << "one that is made later does not forget what came before";
}

TEST(Interrupt, OfARunLeavesItsResults) {
  for (const int signal : {SIGTERM, SIGHUP, SIGQUIT}) {
    const ScratchFolder scratch;
    const std::string rows = scratch.file("rows.csv");
    Process run(scratch, "run",
                {"run", shipped("02_sphere.json"), "--hand", "probe", "--seconds", "60", "--record", rows});
    ASSERT_TRUE(comes([&] { return std::filesystem::exists(rows); }));
    run.kill(signal);
    EXPECT_NE(run.end(), -1) << signal << " ended it at once";
    EXPECT_TRUE(run.says("\"ticks\": ")) << run.output();
    EXPECT_TRUE(run.says("\"guard\": ")) << run.output();
  }
}

}  // namespace underact::test
