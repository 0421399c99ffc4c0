#include "app/page/page.h"

#include <md4c.h>

#include <algorithm>
#include <map>

#include "app/page/html.h"
#include "app/page/tex.h"
#include "app/page/tex_tree.h"
#include "core/base/translate.h"

namespace underact::page {
namespace {

constexpr int kDeepestPage = 60;  // what reads the HTML may go into itself for each level
constexpr std::size_t kMaxProblems = 100;

/// As PageLimits count them.
std::size_t partsOf(std::string_view html) {
  std::size_t parts = 0, depth = 0;
  for (std::size_t at = html.find('<'); at != std::string_view::npos; at = html.find('<', at + 1)) {
    depth -= depth > 0 && html.substr(at).starts_with("</table") ? 1 : 0;
    if (html.substr(at).starts_with("<table")) parts += std::size_t{1} << std::min<std::size_t>(depth++, 60);
    parts += html.substr(at, 2) == "</" ? 0 : 1;
  }
  return parts;
}

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
  Writer(std::string_view markdown, const std::string& file, const LinkTo& link_to, std::size_t max_parts)
      : markdown_(markdown), file_(file), link_to_(link_to), max_parts_(max_parts) {
    page_.sections.emplace_back();
  }
  /// With what is open closed.
  Page take() {
    endSpans();
    if (in_paragraph_) closeParagraph();
    for (; !blocks_.empty(); blocks_.pop_back()) page_.html += blocks_.back();
    return std::move(page_);
  }
  void cut(Sentence why) {
    if (!page_.cut.empty()) return;
    page_.cut = std::move(why);
    page_.problems.push_back({page_.cut, {file_}});
  }

  int enter(MD_BLOCKTYPE type, void* detail);
  int leave(MD_BLOCKTYPE type, void* detail);
  int enter(MD_SPANTYPE type, void* detail);
  int leave(MD_SPANTYPE type, void* detail);
  int text(MD_TEXTTYPE type, std::string_view text);

 private:
  int isCut() const { return page_.cut.empty() ? 0 : 1; }
  bool isTooDeep() {
    if (++depth_ > kDeepestPage)
      cut(phrase(TRANSLATE_NOOP("problem", "The text is cut here: it is nested more than %1 deep."),
                 {std::to_string(kDeepestPage)}));
    return !page_.cut.empty();
  }
  /// Ends are put beside it: what has begun also ends where the page is cut.
  bool put(std::string_view html) {
    parts_ += partsOf(html);
    if (parts_ > max_parts_)
      cut(phrase(TRANSLATE_NOOP("problem", "The text is cut here: it has more than %1 parts."),
                 {std::to_string(max_parts_)}));
    if (page_.cut.empty()) page_.html += html;
    return page_.cut.empty();
  }
  void say(std::string_view plain) { (in_heading_ ? heading_ : page_.sections.back().text) += plain; }
  // md4c 0.4.8 may end a span that it has not begun, or inside another one (an asterisk in a link's target): what is
  // open is closed in its order all the same.
  void openSpan(const char* tag, const std::string& attributes = {}) {
    if (put("<" + std::string(tag) + attributes + ">")) spans_.push_back(tag);
  }
  void closeSpan(std::string_view tag) {
    if (std::find(spans_.begin(), spans_.end(), tag) == spans_.end()) return;
    while (closeLastSpan() != tag) {
    }
  }
  std::string closeLastSpan() {
    std::string tag = std::move(spans_.back());
    spans_.pop_back();
    page_.html += "</" + tag + ">";
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
    in_paragraph_ = put("<p>");
  }
  void closeParagraph() {
    const bool is_empty = page_.html.size() == paragraph_at_ + 3;
    is_empty ? page_.html.resize(paragraph_at_) : (void)page_.html.append("</p>\n");
    in_paragraph_ = false;
  }
  void closeHeading(unsigned level);
  void formula(bool display);
  std::string linked(const std::string& to, bool is_picture);
  int lineOf(const char* at);

  std::string_view markdown_;
  const std::string& file_;
  const LinkTo& link_to_;
  Page page_;
  std::string heading_, formula_, picture_;
  std::vector<std::string> spans_;   // open ones, the innermost last
  std::vector<const char*> blocks_;  // what ends the open ones, the innermost last
  std::size_t heading_at_ = 0, paragraph_at_ = 0, parts_ = 0, max_parts_ = 0;
  const char* counted_to_ = nullptr;  // the lines before it are counted
  int counted_ = 1;
  std::map<std::string, int> anchors_;  // how often each was met
  int depth_ = 0, in_picture_ = 0, line_ = 0;
  bool in_heading_ = false, in_paragraph_ = false, in_formula_ = false;
};

/// The line of what md4c shows, where it is a part of the page and not a text of its own.
int Writer::lineOf(const char* at) {
  const char* start = markdown_.data();
  if (std::less<>()(at, start) || !std::less<>()(at, start + markdown_.size())) return line_;
  if (counted_to_ == nullptr || std::less<>()(at, counted_to_)) {
    counted_to_ = start;
    counted_ = 1;
  }
  counted_ += static_cast<int>(std::count(counted_to_, at, '\n'));
  counted_to_ = at;
  return counted_;
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
  page_.html += "</" + tag + ">\n";
  parts_ += 2;
  if (page_.title.empty()) page_.title = heading_;
  page_.headings.push_back({static_cast<int>(level), heading_, anchor});
  page_.sections.push_back({heading_, anchor, {}});
  in_heading_ = false;
}

int Writer::enter(MD_BLOCKTYPE type, void* detail) {
  if (isTooDeep() || !put(tagsOf(type).begin)) return 1;
  blocks_.push_back(tagsOf(type).end);
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
  return isCut();
}

int Writer::leave(MD_BLOCKTYPE type, void* detail) {
  depth_--;
  endSpans();
  page_.html += blocks_.back();
  blocks_.pop_back();
  if (in_paragraph_) closeParagraph();
  if (type == MD_BLOCK_H) closeHeading(static_cast<MD_BLOCK_H_DETAIL*>(detail)->level);
  if (type != MD_BLOCK_H) say("\n");
  return isCut();
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
  return isCut();
}

int Writer::leave(MD_SPANTYPE type, void*) {
  depth_--;
  if (type == MD_SPAN_IMG && in_picture_ > 0 && --in_picture_ == 0) put(picture_ + "\">");
  if (in_picture_ > 0) return 0;
  if (const char* const tag = tagOf(type)) closeSpan(tag);
  if (isFormula(type) && in_formula_) formula(type == MD_SPAN_LATEXMATH_DISPLAY);
  return isCut();
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
  // What is wrong a hundred times is not looked at once more: to look for the command that was meant takes long.
  const Result<TexNode> tree =
      page_.problems.size() < kMaxProblems ? parseTex(formula_, {file_, line_}) : Problems{{Sentence()}};
  if (is_own_block) closeParagraph();
  if (tree) {
    put(texToHtml(tree.value(), display && spans_.empty() && !in_heading_));
  } else {
    if (page_.problems.size() < kMaxProblems)
      page_.problems.insert(page_.problems.end(), tree.problems().begin(), tree.problems().end());
    put("<code class=\"wrong\">" + escaped(formula_) + "</code>");
  }
  if (is_own_block) openParagraph();
  say(tree ? texToText(tree.value()) : formula_);
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
  return isCut();
}

}  // namespace

Page readPage(std::string_view markdown, const std::string& file, const LinkTo& link_to, const PageLimits& limits) {
  const bool is_long = markdown.size() > limits.bytes;
  if (is_long) {
    std::size_t end = limits.bytes;
    while (end > 0 && (static_cast<unsigned char>(markdown[end]) & 0xC0U) == 0x80U) --end;  // whole letters of UTF-8
    markdown = markdown.substr(0, end);
  }
  Writer writer(markdown, file, link_to, limits.parts);
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
  if (is_long)
    writer.cut(phrase(TRANSLATE_NOOP("problem", "The text is cut here: it is longer than %1 KiB."),
                      {std::to_string(limits.bytes >> 10U)}));
  return writer.take();
}

}  // namespace underact::page
