#include "tests/support/contrast.h"

#include <gtest/gtest.h>

#include <QDirIterator>
#include <QFile>
#include <QPainter>
#include <QRegularExpression>
#include <QStyleOption>
#include <map>

#include "app/gui/kit/contrast.h"
#include "app/gui/kit/focus_style.h"
#include "app/gui/kit/icons.h"
#include "app/gui/kit/page_view.h"
#include "app/gui/kit/style.h"
#include "app/gui/kit/theme.h"
#include "app/page/style.h"

namespace underact::gui {

void PrintTo(const Theme& theme, std::ostream* out) {
  *out << (theme.dark ? "dark" : "light") << (theme.high_contrast ? ", contrasting" : "");
}

namespace {

using underact::test::contrast;

constexpr double kWords = 4.5, kDrawn = 3.0;  // WCAG 2.1, AA: 1.4.3 and 1.4.11

class Contrast : public testing::TestWithParam<Theme> {
 protected:
  const Theme& theme = GetParam();
  const QPalette palette = paletteOf(theme);
  /// What words and marks stand on: panels, the view and the cards, fields and lists.
  const std::map<std::string, QColor> grounds{
      {"panel", palette.color(QPalette::Window)}, {"view", theme.background}, {"field", palette.color(QPalette::Base)}};
};

/// One rule of a style sheet: which widgets, and what it sets.
struct Rule {
  QString who;
  QMap<QString, QString> sets;
  /// Of a colour, or of the colour in "1px solid #0072b2"; none: it sets no such thing, or nothing that is seen.
  QColor colour(const QString& key) const {
    static const QRegularExpression kColour("#[0-9a-f]{6}");
    const QRegularExpressionMatch match = kColour.match(sets.value(key));
    return match.hasMatch() ? QColor(match.captured()) : QColor();
  }
};

QList<Rule> rulesOf(const QString& sheet) {
  static const QRegularExpression kRule("([^{}]+)\\{([^{}]*)\\}");
  QList<Rule> rules;
  for (auto each = kRule.globalMatch(sheet); each.hasNext();) {
    const QRegularExpressionMatch match = each.next();
    Rule rule{match.captured(1).trimmed(), {}};
    for (const QString& one : match.captured(2).split(';', Qt::SkipEmptyParts))
      rule.sets[one.section(':', 0, 0).trimmed()] = one.section(':', 1).trimmed();
    rules << rule;
  }
  return rules;
}

/// The colour of a border, whichever way the rule says it.
QColor borderOf(const Rule& rule) {
  for (const char* key : {"border-color", "border", "border-left"}) {
    if (const QColor colour = rule.colour(key); colour.isValid()) return colour;
  }
  return {};
}

}  // namespace

TEST_P(Contrast, WordsOfThePaletteAreReadable) {
  using P = QPalette;
  for (const auto& [words, ground] : {std::pair{P::WindowText, P::Window},
                                      {P::Text, P::Base},
                                      {P::Text, P::AlternateBase},
                                      {P::ButtonText, P::Button},
                                      {P::ToolTipText, P::ToolTipBase},
                                      {P::PlaceholderText, P::Base},
                                      {P::HighlightedText, P::Highlight},
                                      {P::Link, P::Base},
                                      {P::LinkVisited, P::Base}})
    EXPECT_GE(contrast(palette.color(words), palette.color(ground)), kWords) << words << " on " << ground;
}

TEST_P(Contrast, WordsOfTheStyleSheetAreReadableOnWhatTheyStandOn) {
  int pairs = 0;
  for (const Rule& rule : rulesOf(styleSheet(theme))) {
    const QColor own = rule.colour("background");
    const QColor words = rule.colour("color").isValid() ? rule.colour("color") : theme.ink;
    const bool has_own_words = own.isValid() && !rule.who.contains("separator");
    if (!has_own_words && words == theme.ink) continue;  // the palette's own words, or none
    const auto on = own.isValid() ? std::map<std::string, QColor>{{"its own", own}} : grounds;
    for (const auto& [name, ground] : on) {
      EXPECT_GE(contrast(words, ground), kWords) << rule.who.toStdString() << " on " << name;
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 30);
}

TEST_P(Contrast, WhatTheStyleSheetFramesIsSeenToBeFramed) {
  int frames = 0;
  for (const Rule& rule : rulesOf(styleSheet(theme))) {
    static const QRegularExpression kTelling(
        ":focus|:checked|alarm|amber|stop|start|choice|card|banner");  // others are only neat
    const QColor frame = borderOf(rule);
    if (!rule.who.contains(kTelling) || !frame.isValid()) continue;
    for (const auto& [name, ground] : grounds)
      EXPECT_GE(contrast(frame, ground), kDrawn) << rule.who.toStdString() << " on " << name;
    ++frames;
  }
  EXPECT_GT(frames, 8);
}

TEST_P(Contrast, TheFocusIsSeenOnEveryGroundAndNoRuleHidesIt) {
  for (const auto& [name, ground] : grounds) EXPECT_GE(contrast(focusColour(palette), ground), kDrawn) << name;
  EXPECT_GE(contrast(palette.color(QPalette::Highlight), palette.color(QPalette::Window)), kDrawn);  // of a field
  for (const Rule& rule : rulesOf(styleSheet(theme))) {
    const bool has_frame = borderOf(rule).isValid() || rule.who.contains("::item");  // an item has its ring
    EXPECT_TRUE(has_frame || !rule.who.contains(":focus")) << rule.who.toStdString();
  }
}

TEST_P(Contrast, TheOutlineOfWhatCanBeUsedIsSeenOnWhateverItStandsOn) {
  for (const QPalette::ColorRole role :
       {QPalette::Window, QPalette::Base, QPalette::AlternateBase, QPalette::Button, QPalette::ToolTipBase})
    EXPECT_GE(contrast(outlineColour(palette), palette.color(role)), kDrawn) << role;
}

TEST_P(Contrast, AnUntickedBoxAndAFieldHaveThatOutline) {
  const FocusStyle style;
  const auto edge = [&](auto draw) {
    QImage image(40, 40, QImage::Format_RGB32);
    image.fill(palette.color(QPalette::Window));
    QPainter painter(&image);
    draw(painter);
    return image.pixelColor(5, 20);  // in the middle of the left edge
  };
  QStyleOptionButton box;
  box.rect = QRect(5, 5, 30, 30);
  box.palette = palette;
  box.state = QStyle::State_Enabled | QStyle::State_Off;
  QStyleOptionFrame field;
  field.rect = box.rect;
  field.palette = palette;
  field.state = QStyle::State_Enabled;
  field.lineWidth = 1;
  const std::map<std::string, QColor> edges{
      {"box",
       edge([&](QPainter& painter) { style.drawPrimitive(QStyle::PE_IndicatorCheckBox, &box, &painter, nullptr); })},
      {"field",
       edge([&](QPainter& painter) { style.drawPrimitive(QStyle::PE_FrameLineEdit, &field, &painter, nullptr); })},
      {"button",
       edge([&](QPainter& painter) { style.drawPrimitive(QStyle::PE_PanelButtonCommand, &box, &painter, nullptr); })}};
  for (const auto& [name, colour] : edges)
    EXPECT_GE(contrast(colour, palette.color(QPalette::Window)), kDrawn) << name << ' ' << colour.name().toStdString();
}

TEST_P(Contrast, WhatIsDrawnStandsOutFromTheViewAndFromThePanels) {
  const std::map<std::string, QColor> drawn{{"constraint", theme.constraint},
                                            {"target", theme.target},
                                            {"orientation", theme.orientation},
                                            {"position", theme.position},
                                            {"force", theme.force},
                                            {"force limited", theme.force_limited},
                                            {"virtual robot", theme.virtual_robot},
                                            {"motion", theme.motion},
                                            {"x", theme.x_axis},
                                            {"y", theme.y_axis},
                                            {"z", theme.z_axis},
                                            {"stylus", theme.ink},
                                            {"alarm", alarm(theme)},
                                            {"amber", amber(theme)}};
  for (const auto& [what, colour] : drawn) {
    for (const char* ground : {"view", "panel"})
      EXPECT_GE(contrast(colour, grounds.at(ground)), kDrawn) << what << " on " << ground;
    EXPECT_GE(contrast(readable(colour, theme), theme.background), kWords) << what << ", as a letter in the view";
  }
  EXPECT_EQ(readable(theme.ink, theme), theme.ink) << "no further than needed";
}

TEST_P(Contrast, WordsOfAPageAreReadableMarkedOrNot) {
  PageView view;
  view.setPalette(palette);
  view.showPage("One", {});
  view.mark({"one"});
  QList<QColor> words{palette.color(QPalette::Text)}, on{palette.color(QPalette::Base)};
  for (const Rule& rule : rulesOf(view.document()->defaultStyleSheet())) {
    if (rule.colour("color").isValid()) words << rule.colour("color");
    if (rule.colour("background-color").isValid()) on << rule.colour("background-color");
  }
  EXPECT_GT(words.size(), 4);
  for (const QColor& word : words) {
    for (const QColor& ground : on)
      EXPECT_GE(contrast(word, ground), kWords) << word.name().toStdString() << " on " << ground.name().toStdString();
  }
  ASSERT_EQ(view.extraSelections().size(), 1);
  EXPECT_GE(contrast(words.first(), view.extraSelections().first().format.background().color()), kWords);
}

TEST(ContrastOfPages, WordsOfTheStaticPagesAreReadable) {
  for (const page::Colours& colours : {page::lightColours(), page::darkColours()}) {
    for (const std::string& words : {colours.ink, colours.quiet, colours.link, colours.wrong}) {
      for (const std::string& ground : {colours.ground, colours.soft})
        EXPECT_GE(contrast(QColor(words.c_str()), QColor(ground.c_str())), kWords) << words << " on " << ground;
    }
  }
}

/// Greys are mixed where they are drawn: each such place in the sources, with the share of ink it takes.
TEST_P(Contrast, GreysAndSmallWordsHaveInkEnough) {
  static const QRegularExpression kMixed(
      "mixed\\(([a-z_.]*theme_?\\.(?:quiet|background)|ground|palette\\(\\)\\.color\\(QPalette::Window\\)), "
      "[a-z_.]*theme_?\\.ink, ([0-9.]+)\\)|\\bink\\(([0-9.]+)\\)");
  int places = 0;
  QDirIterator files(UNDERACT_SOURCE "/app/gui", {"*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    QFile file(files.next());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    for (auto each = kMixed.globalMatch(text); each.hasNext(); ++places) {
      const QRegularExpressionMatch match = each.next();
      const bool is_words = match.captured(1).endsWith("quiet");  // ticks, units, captions
      const QColor ground = grounds.at(match.captured(1).endsWith("background") || is_words ? "view" : "panel");
      const QColor grey =
          mixed(is_words ? theme.quiet : ground, theme.ink, (match.captured(2) + match.captured(3)).toDouble());
      EXPECT_GE(contrast(grey, ground), is_words ? kWords : kDrawn)
          << file.fileName().toStdString() << ": " << match.captured().toStdString();
    }
  }
  EXPECT_GT(places, 20);
}

INSTANTIATE_TEST_SUITE_P(Themes, Contrast,
                         testing::Values(Theme::light(), Theme::dark_theme(), Theme::contrasting(false),
                                         Theme::contrasting(true)),
                         [](const auto& each) {
                           return std::string(each.param.high_contrast ? "Contrasting" : "Usual") +
                                  (each.param.dark ? "Dark" : "Light");
                         });

}  // namespace underact::gui
