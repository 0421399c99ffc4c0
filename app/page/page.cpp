#include "app/page/page.h"

#include <md4c.h>

#include <algorithm>
#include <map>

#include "app/page/html.h"
#include "app/page/tex.h"

namespace underact::page {
namespace {

constexpr std::size_t kLargest = std::size_t{1} << 20;
constexpr int kDeepestPage = 60;  // what reads the HTML may go into itself for each level

std::string textOf(const MD_ATTRIBUTE& attribute) {
  return {attribute.text, attribute.size};
}

/// The tags around a block; if begin is not at its end, the attributes of the block follow.
struct Tags {
  const char *begin = "", *end = "";
};
Tags tagsOf(MD_BLOCKTYPE type) {
  switch (type) {
    case MD_BLOCK_QUOTE:
      return {"<blockquote>\n", "</blockquote>\n"};
    case MD_BLOCK_UL:
      return {"<ul>\n", "</ul>\n"};
    case MD_BLOCK_OL:
      return {"<ol start=\"", "</ol>\n"};
    case MD_BLOCK_LI:
      return {"<li>", "</li>\n"};
    case MD_BLOCK_HR:
      return {"<hr>\n", ""};
    case MD_BLOCK_CODE:
      return {"<pre class=\"code\">", "</pre>\n"};
    case MD_BLOCK_TABLE:
      return {"<table class=\"facts\" cellspacing=\"0\" cellpadding=\"4\">\n", "</table>\n"};
    case MD_BLOCK_THEAD:
      return {"<thead>", "</thead>\n"};
    case MD_BLOCK_TBODY:
      return {"<tbody>", "</tbody>\n"};
    case MD_BLOCK_TR:
      return {"<tr>", "</tr>\n"};
    case MD_BLOCK_TH:
      return {"<th align=\"", "</th>"};
    case MD_BLOCK_TD:
      return {"<td align=\"", "</td>"};
    default:
      return {};
  }
}

/// Null: it is not a plain pair of tags.
const char* tagOf(MD_SPANTYPE type) {
  switch (type) {
    case MD_SPAN_EM:
      return "em";
    case MD_SPAN_STRONG:
      return "strong";
    case MD_SPAN_DEL:
      return "s";
    case MD_SPAN_CODE:
      return "code";
    case MD_SPAN_A:
      return "a";
    default:
      return nullptr;
  }
}

bool isFormula(MD_SPANTYPE type) {
  return type == MD_SPAN_LATEXMATH || type == MD_SPAN_LATEXMATH_DISPLAY;
}

/// Builds the page from the parts that md4c reports.
class Writer {
 public:
  Writer(std::string_view markdown, const std::string& file, const LinkTo& link_to)
      : markdown_(markdown), file_(file), link_to_(link_to) {
    page_.sections.emplace_back();
  }
  Page take() { return std::move(page_); }
  void refuse(std::string sentence) { page_.problems.push_back({std::move(sentence), {file_}}); }

  int enter(MD_BLOCKTYPE type, void* detail);
  int leave(MD_BLOCKTYPE type, void* detail);
  int enter(MD_SPANTYPE type, void* detail);
  int leave(MD_SPANTYPE type, void* detail);
  int text(MD_TEXTTYPE type, std::string_view text);

 private:
  bool isTooDeep() {
    if (++depth_ <= kDeepestPage) return false;
    refuse("This page is nested more than 60 deep.");
    return true;
  }
  void put(std::string_view html) { page_.html += html; }
  void say(std::string_view plain) { (in_heading_ ? heading_ : page_.sections.back().text) += plain; }
  // md4c 0.4.8 may end a span that it has not begun, or inside another one (an asterisk in a link's target): what is
  // open is closed in its order all the same.
  void openSpan(const char* tag, const std::string& attributes = {}) {
    put("<" + std::string(tag) + attributes + ">");
    spans_.push_back(tag);
  }
  void closeSpan(std::string_view tag) {
    if (std::find(spans_.begin(), spans_.end(), tag) == spans_.end()) return;
    while (closeLastSpan() != tag) {
    }
  }
  std::string closeLastSpan() {
    std::string tag = std::move(spans_.back());
    spans_.pop_back();
    put("</" + tag + ">");
    return tag;
  }
  /// No span continues after its block.
  void endSpans() {
    if (in_picture_ > 0) put(picture_ + "\">");
    in_picture_ = 0;
    if (in_formula_) formula(false);
    while (!spans_.empty()) closeLastSpan();
  }
  void openParagraph() {
    paragraph_at_ = page_.html.size();
    put("<p>");
    in_paragraph_ = true;
  }
  void closeParagraph() {
    const bool is_empty = page_.html.size() == paragraph_at_ + 3;
    is_empty ? page_.html.resize(paragraph_at_) : put("</p>\n");
    in_paragraph_ = false;
  }
  void closeHeading(unsigned level);
  void formula(bool display);
  std::string linked(const std::string& to, bool is_picture);
  int lineOf(const char* at) const;

  std::string_view markdown_;
  const std::string& file_;
  const LinkTo& link_to_;
  Page page_;
  std::string heading_, formula_, picture_;
  std::vector<std::string> spans_;  // open ones, the innermost last
  std::size_t heading_at_ = 0, paragraph_at_ = 0;
  std::map<std::string, int> anchors_;  // how often each was met
  int depth_ = 0, in_picture_ = 0, line_ = 0;
  bool in_heading_ = false, in_paragraph_ = false, in_formula_ = false;
};

/// The line of what md4c shows, where it is a part of the page and not a text of its own.
int Writer::lineOf(const char* at) const {
  const char* start = markdown_.data();
  if (std::less<>()(at, start) || !std::less<>()(at, start + markdown_.size())) return line_;
  return 1 + static_cast<int>(std::count(start, at, '\n'));
}

std::string Writer::linked(const std::string& to, bool is_picture) {
  page_.links.push_back({to, line_, is_picture});
  return escaped(link_to_ ? link_to_(to) : to);
}

void Writer::closeHeading(unsigned level) {
  std::string anchor = anchorOf(heading_);
  if (const int before = anchors_[anchor]++; before > 0) anchor += "-" + std::to_string(before);
  // Qt finds the name, a browser the id.
  const std::string tag = "h" + std::to_string(level);
  const std::string start = "<" + tag + " id=\"" + escaped(anchor) + "\"><a name=\"" + escaped(anchor) + "\"></a>";
  page_.html.insert(heading_at_, start);
  put("</" + tag + ">\n");
  if (page_.title.empty()) page_.title = heading_;
  page_.headings.push_back({static_cast<int>(level), heading_, anchor});
  page_.sections.push_back({heading_, anchor, {}});
  in_heading_ = false;
}

int Writer::enter(MD_BLOCKTYPE type, void* detail) {
  if (isTooDeep()) return 1;
  put(tagsOf(type).begin);
  if (type == MD_BLOCK_P) openParagraph();
  if (type == MD_BLOCK_OL) put(std::to_string(static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start) + "\">\n");
  if (type == MD_BLOCK_H) {
    heading_at_ = page_.html.size();
    heading_.clear();
    in_heading_ = true;
  }
  if (type == MD_BLOCK_LI) {
    const auto* item = static_cast<MD_BLOCK_LI_DETAIL*>(detail);
    if (item->is_task != 0) put(item->task_mark == ' ' ? "☐ " : "☑ ");
  }
  if (type == MD_BLOCK_TH || type == MD_BLOCK_TD) {
    const MD_ALIGN align = static_cast<MD_BLOCK_TD_DETAIL*>(detail)->align;
    put(align == MD_ALIGN_RIGHT ? "right\">" : align == MD_ALIGN_CENTER ? "center\">" : "left\">");
  }
  return 0;
}

int Writer::leave(MD_BLOCKTYPE type, void* detail) {
  depth_--;
  endSpans();
  put(tagsOf(type).end);
  if (type == MD_BLOCK_P) closeParagraph();
  if (type == MD_BLOCK_H) closeHeading(static_cast<MD_BLOCK_H_DETAIL*>(detail)->level);
  if (type != MD_BLOCK_H) say("\n");
  return 0;
}

int Writer::enter(MD_SPANTYPE type, void* detail) {
  if (isTooDeep()) return 1;
  if (type == MD_SPAN_IMG && in_picture_++ == 0)
    picture_ = "<img src=\"" + linked(textOf(static_cast<MD_SPAN_IMG_DETAIL*>(detail)->src), true) + "\" alt=\"";
  if (in_picture_ > 0) return 0;
  if (type == MD_SPAN_A)
    openSpan("a", " href=\"" + linked(textOf(static_cast<MD_SPAN_A_DETAIL*>(detail)->href), false) + "\"");
  else if (const char* const tag = tagOf(type))
    openSpan(tag);
  if (isFormula(type)) {
    formula_.clear();
    in_formula_ = true;
  }
  return 0;
}

int Writer::leave(MD_SPANTYPE type, void*) {
  depth_--;
  if (type == MD_SPAN_IMG && in_picture_ > 0 && --in_picture_ == 0) put(picture_ + "\">");
  if (in_picture_ > 0) return 0;
  if (const char* const tag = tagOf(type)) closeSpan(tag);
  if (isFormula(type) && in_formula_) formula(type == MD_SPAN_LATEXMATH_DISPLAY);
  return 0;
}

void Writer::formula(bool display) {
  in_formula_ = false;
  // A sum of money, as in "5 $ here and 6 $ there": a formula has no blanks at its ends.
  if (!display && (formula_.empty() || formula_.front() == ' ' || formula_.back() == ' ')) {
    put(escaped("$" + formula_ + "$"));
    return say("$" + formula_ + "$");
  }
  // A table must not be in a paragraph or in bold text.
  const bool is_own_block = display && in_paragraph_ && spans_.empty();
  Result<std::string> made = texToHtml(formula_, display && spans_.empty() && !in_heading_, {file_, line_});
  if (is_own_block) closeParagraph();
  if (made) {
    put(made.value());
  } else {
    page_.problems.insert(page_.problems.end(), made.problems().begin(), made.problems().end());
    put("<code class=\"wrong\">" + escaped(formula_) + "</code>");
  }
  if (is_own_block) openParagraph();
  const Result<std::string> plain = texToText(formula_, {file_, line_});
  say(plain ? plain.value() : formula_);
}

int Writer::text(MD_TEXTTYPE type, std::string_view text) {
  line_ = lineOf(text.data());
  const bool is_break = type == MD_TEXT_BR || type == MD_TEXT_SOFTBR;
  const std::string_view shown = type == MD_TEXT_NULLCHAR ? "\ufffd" : is_break ? " " : text;
  if (in_formula_) {
    formula_ += shown;
    return 0;
  }
  if (in_picture_ > 0) {
    picture_ += escaped(shown);
    return 0;
  }
  say(shown);
  if (type == MD_TEXT_BR)
    put("<br>\n");
  else if (type == MD_TEXT_SOFTBR)
    put("\n");
  else if (type == MD_TEXT_ENTITY)
    put(shown);  // as HTML has it, too
  else
    put(escaped(shown));
  return 0;
}

}  // namespace

Page readPage(std::string_view markdown, const std::string& file, const LinkTo& link_to) {
  Writer writer(markdown, file, link_to);
  if (markdown.size() > kLargest) {
    writer.refuse("A page is at most 1 MiB long.");
    return writer.take();
  }
  MD_PARSER parser{};
  parser.flags = MD_DIALECT_GITHUB | MD_FLAG_LATEXMATHSPANS | MD_FLAG_NOHTML;
  parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* to) {
    return static_cast<Writer*>(to)->enter(type, detail);
  };
  parser.leave_block = [](MD_BLOCKTYPE type, void* detail, void* to) {
    return static_cast<Writer*>(to)->leave(type, detail);
  };
  parser.enter_span = [](MD_SPANTYPE type, void* detail, void* to) {
    return static_cast<Writer*>(to)->enter(type, detail);
  };
  parser.leave_span = [](MD_SPANTYPE type, void* detail, void* to) {
    return static_cast<Writer*>(to)->leave(type, detail);
  };
  parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* to) {
    return static_cast<Writer*>(to)->text(type, {text, size});
  };
  md_parse(markdown.data(), static_cast<MD_SIZE>(markdown.size()), &parser, &writer);
  return writer.take();
}

}  // namespace underact::page
