#include "device/openhaptics/library.h"

#include <gtest/gtest.h>

#include <set>

#include "device/openhaptics/errors.h"
#include "tests/openhaptics/contains.h"

namespace underact::device::openhaptics {
namespace {

int nothing = 0;

}  // namespace

TEST(BindOpenHaptics, AsksForThe36NamesEachOnce) {
  std::set<std::string> asked;
  Calls calls;
  const Problems problems = bind(
      [&](const char* name) -> void* {
        EXPECT_TRUE(asked.insert(name).second) << name;
        return &nothing;
      },
      calls);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(asked.size(), 36U);
}

TEST(BindOpenHaptics, NamesTheOneThatIsNotThereWhicheverItIs) {
  std::set<std::string> names;
  Calls calls;
  (void)bind([&](const char* name) -> void* { return names.insert(name), nullptr; }, calls);
  for (const std::string& absent : names) {
    const Problems problems =
        bind([&](const char* name) -> void* { return name == absent ? nullptr : &nothing; }, calls);
    ASSERT_EQ(problems.size(), 1U) << absent;
    EXPECT_EQ(problems.front().sentence,
              "The library that was found is not OpenHaptics 3.0 to 3.4: it lacks " + absent + ".");
  }
}

TEST(ExplainALibraryThatIsNotLoaded, GivesTheCommandThatMendsIt) {
  struct Row {
    const char* text;
    const char* part;
    const char* command;
  };
  const std::string kNotThere = ": cannot open shared object file: No such file or directory";
  for (const Row& row : {Row{"libHD.so.3.4", "OpenHaptics, is not installed", "sudo ./install"},
                         Row{"libncurses.so.5", "libncurses.so.5", "sudo apt-get install libncurses5 libtinfo5"},
                         Row{"libtinfo.so.5", "libtinfo.so.5", "sudo apt-get install libncurses5 libtinfo5"},
                         Row{"libusb-1.0.so.0", "libusb", "sudo apt-get install libusb-1.0-0"},
                         Row{"libPhantomIOLib42.so", "device driver", "sudo ldconfig"},
                         Row{"libPHANToMIO.so.4", "device driver", "sudo ldconfig"},
                         Row{"libodd.so.2", "libodd.so.2", "apt-cache search libodd"}}) {
    const Missing missing = explain(row.text + kNotThere);
    EXPECT_TRUE(contains(missing.sentence, row.part)) << missing.sentence;
    EXPECT_EQ(missing.command, row.command);
  }
  EXPECT_EQ(explain("libHD.so.3.4: wrong ELF class: ELFCLASS32").sentence,
            "The arm's driver cannot be loaded: libHD.so.3.4: wrong ELF class: ELFCLASS32.");
}

TEST(OpenHapticsErrors, AreOfTheClassThatTheVendorsHelpersHaveThemIn) {
  for (const std::uint32_t code : {0x200U, 0x201U, 0x202U, 0x203U, 0x204U})
    EXPECT_EQ(severityOf(code), Severity::Force);
  for (const std::uint32_t code : {0x302U, 0x303U, 0x304U, 0x500U, 0x501U}) EXPECT_EQ(severityOf(code), Severity::Stop);
  for (const std::uint32_t code : {0x300U, 0x301U, 0x104U, 0x400U, 0x401U, 0x402U, 0x600U, 0x7777U})
    EXPECT_EQ(severityOf(code), Severity::Stop);
  for (const std::uint32_t code : {0x100U, 0x101U, 0x102U, 0x103U}) EXPECT_EQ(severityOf(code), Severity::Question);
  EXPECT_EQ(severityOf(0), Severity::None);
  for (std::uint32_t code = 1; code < 0x700; ++code) EXPECT_TRUE(sentenceOf(code).ends_with(".")) << code;
}

TEST(OpenHapticsErrors, TheWorstOfThemCountsAndAnEndlessStackIsOne) {
  static std::vector<std::uint32_t> stack;
  Calls calls;
  calls.hdGetError = [] {
    if (stack.empty()) return ErrorInfo{};
    const std::uint32_t code = stack.front();
    if (stack.size() > 1 || code != 0x201) stack.erase(stack.begin());
    return ErrorInfo{code, 0, 0};
  };
  stack = {0x101, 0x203, 0x302, 0x300, 0x200};
  const Drained drained = drain(calls);
  EXPECT_EQ(drained.worst, Severity::Stop);
  EXPECT_EQ(drained.code, 0x302U) << "the first of the worst";
  EXPECT_EQ(drained.count, 5);
  EXPECT_EQ(drain(calls).worst, Severity::None);
  stack = {0x201};  // the last one stays for ever
  EXPECT_EQ(drain(calls).code, kEndlessErrors);
}

}  // namespace underact::device::openhaptics
