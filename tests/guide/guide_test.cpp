#include "app/guide/guide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "app/guide/scene_page.h"
#include "app/guide/search.h"
#include "app/guide/site.h"
#include "tests/support/scratch_folder.h"

namespace underact::guide {
namespace {

namespace fs = std::filesystem;

const std::string kFolder = std::string(UNDERACT_SOURCE) + "/resources/guide";

const Guide& theGuide() {
  static const Result<Guide> kGuide = readGuide(kFolder);
  if (kGuide) return kGuide.value();
  for (const Problem& problem : kGuide.problems()) ADD_FAILURE() << describe(problem);
  static const Guide kNone;
  return kNone;
}

std::string textOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

bool hasAnchor(const page::Page& page, const std::string& anchor) {
  for (const page::Page::Heading& heading : page.headings) {
    if (heading.anchor == anchor) return true;
  }
  return anchor.empty();
}

TEST(TheGuide, EveryPageIsInTheContentsOnceAndHasATitleAndFormulasThatCanBeRead) {
  std::set<std::string> in_folder, in_contents;
  for (const fs::directory_entry& file : fs::directory_iterator(kFolder)) {
    if (file.path().extension() == ".md") in_folder.insert(file.path().stem().string());
  }
  for (const Entry& entry : theGuide().entries) {
    in_contents.insert(entry.name);
    EXPECT_FALSE(entry.page.title.empty()) << entry.name;
    EXPECT_EQ(entry.page.headings.empty() ? 0 : entry.page.headings.front().level, 1) << entry.name;
    for (const Problem& problem : entry.page.problems) ADD_FAILURE() << describe(problem);
  }
  EXPECT_EQ(in_folder, in_contents) << "resources/guide/contents.json names the pages";
  EXPECT_GT(in_contents.size(), 40u);
}

TEST(TheGuide, EveryLinkLeadsSomewhere) {
  int links = 0, scenes = 0, pictures = 0;
  for (const Entry& entry : theGuide().entries) {
    for (const page::Page::Link& link : entry.page.links) {
      const std::string where = entry.name + ".md:" + std::to_string(link.line) + ": " + link.to;
      ++links;
      if (link.is_picture) {
        EXPECT_EQ(link.to.rfind("../pictures/", 0), 0u) << where;
        EXPECT_TRUE(fs::is_regular_file(fs::path(kFolder) / link.to)) << where;
        ++pictures;
      } else if (link.to.rfind("scene:", 0) == 0) {
        EXPECT_TRUE(fs::is_regular_file(UNDERACT_SOURCE "/scenes/" + link.to.substr(6) + ".json")) << where;
        ++scenes;
      } else if (const Target target = targetOf(link.to); target.is_page) {
        const Entry* other = target.page.empty() ? &entry : theGuide().find(target.page);
        ASSERT_NE(other, nullptr) << where;
        EXPECT_TRUE(hasAnchor(other->page, target.anchor)) << where;
      } else if (link.to.ends_with(".ipynb")) {
        EXPECT_TRUE(fs::is_regular_file(fs::path(kFolder) / link.to)) << where;
      } else {
        const bool is_known = link.to.rfind("https://", 0) == 0 || link.to.rfind("action:", 0) == 0 ||
                              link.to.rfind("lesson:", 0) == 0;  // actions: in a story
        EXPECT_TRUE(is_known) << where;
      }
    }
  }
  EXPECT_GT(links, 200);
  EXPECT_GT(scenes, 60);
  EXPECT_GT(pictures, 12);
}

TEST(TheGuide, TheReadmeNamesPagesThatAreThere) {
  const page::Page readme = page::readPage(textOf(UNDERACT_SOURCE "/README.md"), "README.md");
  int pages = 0;
  for (const page::Page::Link& link : readme.links) {
    if (link.to.find("://") != std::string::npos) continue;
    EXPECT_TRUE(fs::exists(UNDERACT_SOURCE "/" + link.to)) << link.to;
    pages += link.to.rfind("resources/guide/", 0) == 0 ? 1 : 0;
  }
  EXPECT_GT(pages, 5);
}

TEST(Contents, NamesEachErrorInTheList) {
  const test::ScratchFolder scratch;
  const fs::path folder = scratch.path();
  write(folder / "a.md", "# A\n");
  const auto problemOf = [&](const std::string& contents) {
    write(folder / "contents.json", contents);
    const Result<Guide> read = readGuide(folder.string());
    return read ? std::string("none") : describe(read.problems().front());
  };
  const std::string start = R"({"underact_guide": 1, "chapters": [{"title": "T", "pages": [)";
  EXPECT_EQ(problemOf(start + "\"a\"]}]}"), "none");
  EXPECT_NE(problemOf(start + "\"a\", \"a\"]}]}").find("twice"), std::string::npos);
  EXPECT_NE(problemOf(start + "\"../a\"]}]}").find("not a page"), std::string::npos);
  EXPECT_NE(problemOf(start + "\"b\"]}]}").find("b.md"), std::string::npos);
  EXPECT_NE(problemOf(start + "1]}]}").find("contents.json:1"), std::string::npos);
  EXPECT_NE(problemOf(R"({"underact_guide": 2, "chapters": []})").find("version"), std::string::npos);
  EXPECT_NE(problemOf(R"({"underact_guide": 1, "chapter": []})").find("chapter"), std::string::npos);
  EXPECT_NE(problemOf("{").find("contents.json"), std::string::npos);
}

TEST(Targets, ArePageAndAnchorOfALink) {
  EXPECT_EQ(targetOf("faults.md#not-tried").page, "faults");
  EXPECT_EQ(targetOf("faults.md#not-tried").anchor, "not-tried");
  EXPECT_EQ(targetOf("guide:faults").page, "faults");
  EXPECT_EQ(targetOf("#here").anchor, "here");
  EXPECT_TRUE(targetOf("#here").is_page);
  for (const char* other : {"scene:02_sphere", "https://a.example/b.md", "../pictures/a.png", "../../README.md"})
    EXPECT_FALSE(targetOf(other).is_page) << other;
}

/// A guide of three pages.
Guide small() {
  Guide guide;
  guide.chapters = {{"One", {"walls", "spheres", "arms"}}};
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"walls", "# Walls\n\nA sphere is no wall.\n\n## Buzzing\n\nStiff walls buzz, walls with damping do not.\n"},
           {"spheres", "# Spheres\n\nThe sphere has a centre. Größe: a word of two bytes a letter.\n"},
           {"arms", "# Arms\n\nwallet\n"}})
    guide.entries.push_back({name, text, page::readPage(text, name)});
  return guide;
}

TEST(SearchOfPages, TitlesComeBeforeTextAndWholeWordsBeforeBeginnings) {
  const Guide guide = small();
  const Search search(guide);
  const std::vector<Hit> hits = search.find("wall");
  ASSERT_EQ(hits.size(), 3u);
  EXPECT_EQ(hits[0].title, "Walls");
  EXPECT_EQ(hits[1].title, "Buzzing");
  EXPECT_EQ(hits[2].title, "Arms");
  EXPECT_EQ(hits[1].anchor, "buzzing");
  EXPECT_NE(hits[1].excerpt.find("Stiff walls buzz"), std::string::npos);
  EXPECT_EQ(search.find("spheres").front().excerpt.rfind("The sphere has a centre", 0), 0u) << "found by its title";
}

TEST(SearchOfPages, EachWordMustBeThereInAnyCase) {
  const Guide guide = small();
  const Search search(guide);
  EXPECT_EQ(search.find("SPHERE centre").size(), 1u);
  EXPECT_EQ(search.find("sphere").size(), 2u);
  EXPECT_EQ(search.find("sphere nothing").size(), 0u);
  EXPECT_EQ(search.find("GRÖSSE").size(), 0u) << "ß is another letter";
  EXPECT_EQ(search.find("GRÖß").size(), 1u);
  EXPECT_EQ(search.find("  ,. ").size(), 0u);
  EXPECT_EQ(search.find("phere").size(), 0u) << "words begin with what is typed";
  EXPECT_EQ(search.find("a", 2).size(), 2u);
}

TEST(SearchOfPages, FindsInTheGuideWhatPeopleLookFor) {
  const Search search(theGuide());
  const auto first = [&](const char* typed) {
    const std::vector<Hit> hits = search.find(typed);
    return hits.empty() ? std::string() : hits.front().page;
  };
  EXPECT_EQ(first("safety"), "safety");
  EXPECT_EQ(first("energy"), "energy");
  EXPECT_EQ(first("hold to run"), "servo");
  EXPECT_EQ(first("jacobian singularities"), "course_jacobian");
  const std::vector<Hit> gains = search.find("kp_N_per_mm");  // scene files, and who sets them from outside
  EXPECT_TRUE(std::any_of(gains.begin(), gains.begin() + std::min<std::ptrdiff_t>(3, std::ssize(gains)),
                          [](const Hit& hit) { return hit.page.starts_with("scene"); }));
}

TEST(SceneList, HasTitleAboutAndWhatAClassReadsOfIt) {
  const test::ScratchFolder scratch;
  write(scratch.file("02_b.json"), R"({"title": "B_2", "about": "Two *stars*.", "teach": {"try": "Turn $x$."}})");
  write(scratch.file("01_a.json"), R"({"title": "A", "about": "One."})");
  write(scratch.file("scene.schema.json"), "{}");
  const Result<std::string> page = sceneList(scratch.path());
  ASSERT_TRUE(page);
  const page::Page read = page::readPage(page.value(), "list");
  ASSERT_EQ(read.headings.size(), 3u);
  EXPECT_EQ(read.headings[1].anchor, "01_a");
  EXPECT_EQ(read.headings[2].anchor, "02_b");
  EXPECT_EQ(read.links[1].to, "scene:02_b");
  EXPECT_NE(read.html.find("Two *stars*."), std::string::npos);
  EXPECT_NE(read.html.find("Turn <span class=\"formula\"><i>x</i></span>."), std::string::npos) << read.html;
  write(scratch.file("03_c.json"), "{");
  EXPECT_FALSE(sceneList(scratch.path()));
}

TEST(ScenePage, RefusesASchemaThatIsNotOfScenes) {
  const test::ScratchFolder scratch;
  const std::string schema = textOf(UNDERACT_SOURCE "/scenes/scene.schema.json");
  for (const char* part :
       {"\"constraints\": {", "\"$defs\": {", "\"oneOf\": [", "\"sphere\": {", "\"control\": {\n      \"type\""}) {
    std::string damaged = schema;
    const std::size_t at = damaged.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    damaged[at + 1] = 'X';
    EXPECT_FALSE(scenePage(scratch.write("schema.json", damaged))) << part;
  }
  EXPECT_TRUE(scenePage(scratch.write("schema.json", schema)));
  EXPECT_FALSE(scenePage(scratch.write("schema.json", "[]")));
}

TEST(StaticPages, EveryLinkOfEveryPageIsAFileAndNothingComesFromTheNet) {
  const test::ScratchFolder scratch;
  for (const Problem& problem : writeSite(theGuide(), scratch.path())) ADD_FAILURE() << describe(problem);
  int links = 0;
  for (const Entry& entry : theGuide().entries) {
    const std::string html = textOf(fs::path(scratch.path()) / (entry.name + ".html"));
    ASSERT_NE(html.find("</html>"), std::string::npos) << entry.name;
    for (const char* attribute : {"href=\"", "src=\""}) {
      const std::string start = attribute;
      for (std::size_t at = html.find(start); at != std::string::npos; at = html.find(start, at + 1)) {
        const std::string to = html.substr(at + start.size(), html.find('"', at + start.size()) - at - start.size());
        const std::string file = to.substr(0, to.find('#'));
        ++links;
        if (start == "href=\"" && to.rfind("https://", 0) == 0) continue;
        if (file.empty()) continue;
        if (file == "lessons.html" && theGuide().find("lessons") == nullptr) continue;
        EXPECT_TRUE(fs::is_regular_file(fs::path(scratch.path()) / file)) << entry.name << ": " << to;
      }
    }
  }
  EXPECT_GT(links, 1000);
  EXPECT_TRUE(fs::is_regular_file(fs::path(scratch.path()) / "index.html"));
  EXPECT_TRUE(fs::is_regular_file(fs::path(scratch.path()) / "search_index.js"));
}

TEST(StaticPages, AreTheSameBytesEachTimeAndHaveLightAndDark) {
  const test::ScratchFolder one, two;
  EXPECT_TRUE(writeSite(theGuide(), one.path()).empty());
  EXPECT_TRUE(writeSite(theGuide(), two.path()).empty());
  for (const char* name : {"start.html", "style.css", "search_index.js", "scene_list.html"}) {
    const std::string text = textOf(fs::path(one.path()) / name);
    EXPECT_FALSE(text.empty()) << name;
    EXPECT_EQ(text, textOf(fs::path(two.path()) / name)) << name;
  }
  EXPECT_NE(textOf(fs::path(one.path()) / "style.css").find("prefers-color-scheme: dark"), std::string::npos);
  EXPECT_NE(textOf(fs::path(one.path()) / "experiments.html").find("<body class=\"experiments\">"), std::string::npos)
      << "site.css prints a worksheet a sheet";
}

TEST(StaticPages, ReportsWhatItCannotWrite) {
  EXPECT_FALSE(writeSite(theGuide(), "/proc/no_such_folder").empty());
}

}  // namespace
}  // namespace underact::guide
