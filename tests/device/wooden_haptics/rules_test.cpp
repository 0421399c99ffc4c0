// Whoever may not open an arm is told a command; whoever installed the package needs none. So every id that the program
// knows stands in the rules that it installs.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "device/wooden_haptics/models.h"
#include "tests/support/pattern.h"

namespace underact::device {
namespace {

using Id = std::pair<std::string, std::string>;  // vendor, product; four small hex digits, as udev compares them

std::string hex(unsigned value) {
  char text[8];
  std::snprintf(text, sizeof text, "%04x", value);
  return text;
}

/// The ids that a rule gives to whoever sits there; a rule without a product: "*".
std::set<Id> idsOf(const std::string& rules) {
  constexpr const char* kRule =
      R"re((^|\n)[A-Z]+=="[^"]*", ATTRS?\{idVendor\}=="([0-9a-f]{4})",( ATTRS?\{idProduct\}=="([0-9a-f|]+)",)? TAG\+="uaccess")re";
  std::set<Id> ids;
  for (const test::PatternMatch& rule : test::matchesOf(kRule, rules)) {
    const std::string products = rule.groups[4].empty() ? "*" : rule.groups[4];
    for (std::size_t at = 0; at < products.size(); at += 5) ids.insert({rule.groups[2], products.substr(at, 4)});
  }
  return ids;
}

std::string rulesText() {
  std::ifstream file(UNDERACT_SOURCE "/packaging/udev/70-underact.rules");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST(UdevRules, NameEveryArmOverHid) {
  const std::set<Id> ids = idsOf(rulesText());
  for (const WoodenId& id : woodenIds()) EXPECT_TRUE(ids.contains({hex(id.vendor), hex(id.product)})) << id.board;
}

TEST(UdevRules, NameTheTouchAndEvery3dMouse) {  // facts on devices, 3.3 and 4
  const std::set<Id> ids = idsOf(rulesText());
  EXPECT_TRUE(ids.contains({"2988", "*"}));
  EXPECT_TRUE(ids.contains({"0301", "2988"}));
  for (const unsigned product :
       {0xC603U, 0xC605U, 0xC606U, 0xC621U, 0xC623U, 0xC625U, 0xC626U, 0xC627U, 0xC628U, 0xC629U, 0xC62BU})
    EXPECT_TRUE(ids.contains({"046d", hex(product)})) << hex(product);
  for (const unsigned product :
       {0xC62EU, 0xC62FU, 0xC631U, 0xC632U, 0xC633U, 0xC635U, 0xC636U, 0xC638U, 0xC63AU, 0xC652U})
    EXPECT_TRUE(ids.contains({"256f", hex(product)})) << hex(product);
}

TEST(UdevRules, EachLineIsARuleOrARemark) {  // what the pattern above does not know is no rule, but a slip
  std::ifstream file(UNDERACT_SOURCE "/packaging/udev/70-underact.rules");
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.find("KERNELS==\"0005:") != std::string::npos) continue;
    EXPECT_FALSE(idsOf(line).empty()) << line;
  }
}

}  // namespace underact::device
