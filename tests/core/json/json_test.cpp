#include "core/json/json.h"

#include <algorithm>
#include <cmath>

#include "core/json/text.h"
#include "tests/core/scene/scene_support.h"

namespace underact::json {
namespace {

std::string syntaxProblem(const std::string& text) {
  const Result<Value> parsed = parse(text, "f");
  if (parsed) return "none";
  EXPECT_EQ(parsed.problems().size(), 1u);
  const SourceLocation& place = parsed.problems()[0].place;
  EXPECT_EQ(place.file, "f");
  return std::to_string(place.line) + ":" + std::to_string(place.column) + ": " + parsed.problems()[0].sentence;
}

Value valueOf(const std::string& text) {
  return parse(text, "f").value();
}

TEST(Json, EveryKindIsReadWithThePlaceOfItsFirstCharacter) {
  const Value root = valueOf("{\n  \"a\": [1, -2.5e1, true],\n\t\"b\" : {\"c\": null, \"d\": \"x\"}, \"e\": false\n}");
  EXPECT_EQ(root.kind, JsonKind::Object);
  EXPECT_EQ(root.keys, (std::vector<std::string>{"a", "b", "e"}));
  EXPECT_EQ(root.key_places[1], (std::pair{3, 2}));
  const Value& list = *root.find("a");
  EXPECT_EQ(list.kind, JsonKind::Array);
  EXPECT_EQ((std::pair{list.line, list.column}), (std::pair{2, 8}));
  EXPECT_EQ(list.items[1].number, -25.0);
  EXPECT_EQ((std::pair{list.items[1].line, list.items[1].column}), (std::pair{2, 12}));
  EXPECT_TRUE(list.items[2].boolean);
  EXPECT_EQ(list.items[2].column, 20);
  const Value& object = *root.find("b");
  EXPECT_EQ((std::pair{object.line, object.column}), (std::pair{3, 8}));
  EXPECT_EQ(object.find("c")->kind, JsonKind::Null);
  EXPECT_EQ(object.find("c")->column, 14);
  EXPECT_EQ(object.find("d")->text, "x");
  EXPECT_EQ(object.find("d")->column, 25);
  EXPECT_EQ(root.find("e")->kind, JsonKind::Bool);
  EXPECT_EQ(root.find("e")->column, 36);
  EXPECT_EQ(root.find("z"), nullptr);
}

TEST(Json, NumbersAndQuotesWithinTextAreText) {
  const Value list = valueOf(R"(["12", "a \" 34 \\", 56, "\\", -7, "\\\" 8"])");
  EXPECT_EQ(list.items[0].text, "12");
  EXPECT_EQ(list.items[1].text, "a \" 34 \\");
  EXPECT_EQ(list.items[2].number, 56.0);
  EXPECT_EQ(list.items[4].number, -7.0);
  EXPECT_EQ(list.items[5].text, "\\\" 8");
}

/// The distance of Levenshtein, by its definition alone.
std::size_t distanceOf(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0)
        d[i][j] = i + j;
      else
        d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
    }
  }
  return d[a.size()][b.size()];
}

TEST(NearestWord, IsFoundUpToAThirdOfItsLettersAndNotBeyond) {
  test::Random random(test::Seed{20261127});
  int found = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::string word, known;
    for (std::size_t i = random.below(60) + 1; i > 0; --i) word += static_cast<char>('a' + random.below(3));
    for (const char letter : word) {
      const std::size_t slip = random.below(6);
      if (slip != 0) known += slip == 1 ? 'c' : letter;
      if (slip == 2) known += 'b';
    }
    const std::size_t max = word.size() < 4 ? 1 : std::clamp<std::size_t>(word.size() / 3, 2, 12);
    const bool is_near = distanceOf(word, known) <= max;
    ASSERT_EQ(nearestWord(word, {known}), is_near ? known : "") << word << " " << known;
    found += is_near ? 1 : 0;
  }
  EXPECT_GT(found, 5'000);
  EXPECT_LT(found, 19'000);
}

TEST(Json, ColumnsCountCharactersNotBytes) {
  const Value root = valueOf("{\"K\xC3\xB6nig \xF0\x9F\x98\x80\": 1}");
  EXPECT_EQ(root.items[0].column, 13);
}

TEST(Json, AByteOrderMarkIsSkippedAndTakesNoColumn) {
  EXPECT_EQ(valueOf("\xEF\xBB\xBF[1]").items[0].column, 2);
}

TEST(Json, OfAKeyThatStandsTwiceTheFirstIsFound) {
  const Value root = valueOf("{\"a\": 1, \"a\": 2}");
  EXPECT_EQ(root.find("a")->number, 1.0);
  EXPECT_EQ(root.keys.size(), 2u);
}

TEST(Json, ANumberBeyondDoubleKeepsItsPlaceAndTheOthersAreStillRead) {
  const Value list = valueOf("[1e400, -1e999999999999999999999, 1e-400, -0, 7, " + std::string(400, '9') +
                             ", 0.000e99999999999999999999, 0." + std::string(400, '0') + "1e402]");
  EXPECT_EQ(list.items[0].number, kInfinity);
  EXPECT_EQ(list.items[1].number, -kInfinity);
  EXPECT_EQ(list.items[1].column, 9);
  EXPECT_EQ(list.items[2].number, 0.0);
  EXPECT_TRUE(std::signbit(list.items[3].number));
  EXPECT_EQ(list.items[4].number, 7.0);
  EXPECT_EQ(list.items[5].number, kInfinity);
  EXPECT_EQ(list.items[6].number, 0.0);
  EXPECT_EQ(list.items[7].number, 10.0);
}

TEST(Json, TheGrammarOfNumbersIsTheOneOfRfc8259) {
  for (const char* good : {"0", "-0", "10", "0.5", "1e5", "1E+5", "1e-05", "-12.25e-3"}) {
    EXPECT_EQ(syntaxProblem(good), "none") << good;
  }
  for (const char* bad : {"01", "+1", ".5", "1.", "-", "1e", "1e+", "0x10", "1_000", "1-2", "1.2.3", "--1", "NaN",
                          "Infinity", "-Infinity", "1e999-"}) {
    EXPECT_NE(syntaxProblem(bad), "none") << bad;
  }
}

TEST(Json, ASyntaxErrorSaysWhatWasExpectedAndWhere) {
  EXPECT_EQ(syntaxProblem(""), "1:1: The file is empty; an object in { } was expected.");
  EXPECT_EQ(syntaxProblem("{\"a\": 1\n \"b\": 2}"), "2:2: A comma or a } was expected here.");
  EXPECT_EQ(syntaxProblem("[1 2]"), "1:4: A comma or a ] was expected here.");
  EXPECT_EQ(syntaxProblem("{\"a\" 1}"), "1:6: A colon was expected after the key.");
  EXPECT_EQ(syntaxProblem("{a: 1}"), "1:2: A key in double quotes was expected.");
  EXPECT_EQ(syntaxProblem("{\"a\": 1,}"),
            "1:9: There is a comma before this }; remove it, or write another key after it.");
  EXPECT_EQ(syntaxProblem("[1,\n]"),
            "2:1: There is a comma before this bracket; remove it, or write another value after it.");
  EXPECT_EQ(
      syntaxProblem("{\"a\": NaN}"),
      "1:7: A value was expected; \"NaN\" is not one. Numbers look like 0.5, -3 or 1e-3; text is in double quotes.");
  EXPECT_EQ(
      syntaxProblem("{\"a\": tru}"),
      "1:7: A value was expected; \"tru\" is not one. Numbers look like 0.5, -3 or 1e-3; text is in double quotes.");
  EXPECT_EQ(
      syntaxProblem("[-]"),
      "1:2: A value was expected; \"-\" is not one. Numbers look like 0.5, -3 or 1e-3; text is in double quotes.");
  EXPECT_EQ(syntaxProblem("['a']"), "1:2: Text must be in double quotes, not in single ones.");
  EXPECT_EQ(syntaxProblem("[1, // two\n2]"), "1:5: JSON has no comments; remove this.");
  EXPECT_EQ(syntaxProblem("{\"a\": 1} {"), "1:10: The text should end before this: all its brackets are closed.");
  EXPECT_EQ(syntaxProblem("{\"a\": [1, 2"), "1:12: The text ends too early: a ] is missing.");
  EXPECT_EQ(syntaxProblem("{\"a\": 1\n"), "2:1: The text ends too early: a } is missing.");
  EXPECT_EQ(syntaxProblem("{\"a\":"), "1:6: The text ends too early: a value was expected.");
  EXPECT_EQ(syntaxProblem("{"), "1:2: The text ends too early: a key in double quotes or a } was expected.");
  EXPECT_EQ(syntaxProblem("[\"ab"), "1:2: This text is not closed: its second double quote is missing.");
  EXPECT_EQ(syntaxProblem("[\"ab\n\"]"),
            "1:2: This text does not end on its line: its second double quote is missing.");
  EXPECT_EQ(syntaxProblem("[\"C:\\dir\"]"),
            "1:5: JSON does not know this escape; a backslash itself is written \\\\, a new line \\n.");
  EXPECT_EQ(syntaxProblem("[\"a\tb\"]"), "1:4: There is a control character in this text; a tab is written \\t.");
  EXPECT_EQ(syntaxProblem("[\"\\u12g4\"]"), "1:3: Four digits of 0-9 and a-f are expected after \\u.");
}

TEST(Json, BothHalvesOfAPairOfEscapesAreNeeded) {
  EXPECT_EQ(valueOf("[\"\\ud83d\\ude00\"]").items[0].text, "\xF0\x9F\x98\x80");
  EXPECT_EQ(syntaxProblem("[\"\\ud83d\"]"), "1:3: This \\u escape is half of a pair; its other half is missing.");
  EXPECT_EQ(syntaxProblem("[1, \"\\ude00\"]"),
            "1:5: A \\u escape in this text is half of a pair; its other half is missing.");
  EXPECT_EQ(syntaxProblem("{\"\\ude00\": 1}"),
            "1:2: A \\u escape in this text is half of a pair; its other half is missing.");
}

TEST(Json, RefusesInvalidUtf8AtItsFirstByte) {
  const char* sentence = ": This is not text in UTF-8; save the file as UTF-8.";
  for (const char* bytes : {"\x80", "\xC0\xAF", "\xC3", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF0\x80\x80\x80",
                            "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xE2\x82", "\xFF"}) {
    EXPECT_EQ(syntaxProblem(std::string("[\n\"a") + bytes + "\"]"), std::string("2:3") + sentence);
  }
  EXPECT_EQ(syntaxProblem(std::string("[1]\0[2]", 7)), std::string("1:4") + sentence);
  EXPECT_EQ(syntaxProblem("[\"\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF\"]"),
            "none");  // the neighbours of what is refused
}

TEST(Json, SixtyFourLevelsAreReadAndNotOneMore) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + "1" + std::string(depth, ']'); };
  EXPECT_EQ(syntaxProblem(nested(64)), "none");
  EXPECT_EQ(syntaxProblem(nested(65)), "1:65: Lists and objects are nested more than 64 levels deep here.");
  EXPECT_EQ(syntaxProblem(std::string(5'000'000, '[')),
            "1:65: Lists and objects are nested more than 64 levels deep here.");
}

TEST(Json, AnAbsurdNumberOfValuesIsRefused) {
  std::string text = "[";
  for (int i = 0; i < 1'100'000; ++i) text += "0,";
  EXPECT_EQ(syntaxProblem(text + "0]").substr(0, 50), "1:2000003: The file contains more than a million v");
}

TEST(Json, NumbersAreWrittenAsShortAsReadsBackToTheSameBits) {
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(-0.0), "-0.0");  // of "-0" Python makes the integer 0
  EXPECT_EQ(numberText(40.0), "40");
  EXPECT_EQ(numberText(kNotANumber), "null");
  EXPECT_EQ(numberText(kInfinity), "null");
  test::Random random(test::Seed{20070601});
  for (int i = 0; i < test::sweep(20000, 2000000); ++i) {
    const std::uint64_t bits = random.bits();
    double number = 0.0;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number)) continue;
    ASSERT_TRUE(test::same(valueOf(numberText(number)).number, number)) << numberText(number);
  }
}

TEST(Json, QuotedTextReadsBackToItself) {
  std::string text;
  for (int c = 0; c < 0x80; ++c) text += static_cast<char>(c);
  text += "\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80";
  EXPECT_EQ(valueOf(json::quotedText(text)).text, text);
  EXPECT_EQ(json::quotedText("a\xFFz"),
            "\"a\xEF\xBF\xBDz\"");  // what is no UTF-8 becomes a mark, not an unreadable file
}

}  // namespace
}  // namespace underact::json
