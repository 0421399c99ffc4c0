#include "app/page/tex.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/page/html.h"

namespace underact::page {
namespace {

const std::string kTable = " cellspacing=\"0\" cellpadding=\"0\"";

bool isTall(const TexNode& node) {
  if (node.kind == TexKind::Fraction || node.kind == TexKind::Grid) return true;
  return std::any_of(node.parts.begin(), node.parts.end(), isTall);
}

/// One letter, number or word, which needs no brackets beside a slash.
bool isSingle(const TexNode& node) {
  switch (node.kind) {
    case TexKind::Row:
      return node.parts.size() == 1 && isSingle(node.parts.front());
    case TexKind::Fraction:
    case TexKind::Operator:
      return false;
    default:
      return true;
  }
}

/// An operator is a sign where nothing stands before it that it could join to what follows.
bool isSign(const TexNode& row, std::size_t index) {
  while (index > 0 && row.parts[index - 1].kind == TexKind::Space && !row.parts[index - 1].text.empty()) --index;
  if (index == 0) return true;
  const TexNode& before = row.parts[index - 1];
  return before.kind == TexKind::Operator || before.text == "(" || before.text == "[" || before.text == ", ";
}

/// Inside a sentence: everything on one line. space: what stands around an operator.
class Line {
 public:
  explicit Line(std::string_view space) : space_(space) {}

  std::string of(const TexNode& node) const {
    switch (node.kind) {
      case TexKind::Row:
        return row(node);
      case TexKind::Letter:
        return "<i>" + escaped(node.text) + "</i>";
      case TexKind::Operator:
        return space_ + escaped(node.text) + space_;
      case TexKind::Upright:
      case TexKind::Space:
        return escaped(node.text);
      case TexKind::Script:
        return script(node);
      case TexKind::Fraction:
        return beside(node.parts[0]) + "/" + beside(node.parts[1]);
      case TexKind::Root:
        return "√" + (isSingle(node.parts[0]) ? of(node.parts[0]) : "(" + of(node.parts[0]) + ")");
      case TexKind::Accent:
        return accent(node);
      case TexKind::Bold:
        return "<b>" + of(node.parts[0]) + "</b>";
      case TexKind::Fence:
        return escaped(node.text) + of(node.parts[0]) + escaped(node.right);
      case TexKind::Grid:
        return grid(node);
    }
    return {};
  }

 private:
  std::string row(const TexNode& node) const {
    std::string made;
    for (std::size_t i = 0; i < node.parts.size(); ++i) {
      const TexNode& part = node.parts[i];
      if (part.kind == TexKind::Operator && isSign(node, i))
        made += escaped(part.text);
      else
        made += of(part);
      // "sin θ", but "sin(θ)" and "sin²θ"
      if (part.kind == TexKind::Upright && part.text.size() > 1 &&
          std::isalpha(static_cast<unsigned char>(part.text[0])) && i + 1 < node.parts.size() &&
          node.parts[i + 1].kind == TexKind::Letter)
        made += "\u2009";
    }
    return made;
  }

  std::string script(const TexNode& node) const {
    const Line tight("");
    std::string made = of(node.parts[0]);
    if (!node.parts[1].parts.empty()) made += "<sub>" + tight.of(node.parts[1]) + "</sub>";
    if (!node.parts[2].parts.empty()) made += "<sup>" + tight.of(node.parts[2]) + "</sup>";
    return made;
  }

  std::string beside(const TexNode& node) const { return isSingle(node) ? of(node) : "(" + of(node) + ")"; }

  /// The mark follows the last letter that it is over, before the end of the italics.
  std::string accent(const TexNode& node) const {
    std::string made = of(node.parts[0]);
    std::size_t end = made.size();
    while (end > 0 && made[end - 1] == '>') end = made.rfind('<', end - 1);
    return made.insert(end == std::string::npos ? made.size() : end, node.text);
  }

  std::string grid(const TexNode& node) const {
    std::string made = "[";
    for (std::size_t i = 0; i < node.parts.size(); ++i) {
      if (i > 0) made += i % node.columns == 0 ? "; " : ", ";
      made += of(node.parts[i]);
    }
    return made + "]";
  }

  std::string space_;
};

/// On a line of its own: cells side by side, with tables for stacked parts.
class Display {
 public:
  /// Cells of a table's row.
  std::string cells(const TexNode& node) const {
    if (!isTall(node)) return cell(line_.of(node));
    switch (node.kind) {
      case TexKind::Row:
        return row(node);
      case TexKind::Script:
        return script(node);
      case TexKind::Fraction:
        return cell(fraction(node));
      case TexKind::Root:
        return cell(tall("√")) + "<td class=\"roof\">" + box(node.parts[0]) + "</td>";
      case TexKind::Fence:
        return bracket(node.text, true) + cells(node.parts[0]) + bracket(node.right, false);
      case TexKind::Grid:
        return grid(node);
      default: {
        std::string made;
        for (const TexNode& part : node.parts) made += cells(part);
        return made;
      }
    }
  }

 private:
  static std::string cell(const std::string& html) { return "<td class=\"math\">" + html + "</td>"; }
  static std::string tall(const std::string& text) { return "<span class=\"tall\">" + escaped(text) + "</span>"; }

  /// One block, for where a cell is already there.
  std::string box(const TexNode& node) const {
    return isTall(node) ? "<table" + kTable + "><tr>" + cells(node) + "</tr></table>" : line_.of(node);
  }

  std::string row(const TexNode& node) const {
    std::string made;
    TexNode flat;  // the parts of the row on one line, since the last tall part
    const auto end = [&] {
      if (!flat.parts.empty()) made += cell(line_.of(flat));
      flat.parts.clear();
    };
    for (const TexNode& part : node.parts) {
      if (!isTall(part)) {
        // An operator after a tall part is not a sign.
        if (flat.parts.empty() && !made.empty()) flat.parts.push_back({TexKind::Space, ""});
        flat.parts.push_back(part);
        continue;
      }
      end();
      made += cells(part);
    }
    end();
    return made;
  }

  std::string fraction(const TexNode& node) const {
    return "<table class=\"fraction\" align=\"center\"" + kTable + "><tr><td class=\"over\" align=\"center\">" +
           box(node.parts[0]) + "</td></tr><tr><td class=\"under\" align=\"center\">" + box(node.parts[1]) +
           "</td></tr></table>";
  }

  std::string script(const TexNode& node) const {
    const Line tight("");
    std::string made = cells(node.parts[0]);
    if (!node.parts[2].parts.empty()) made += "<td valign=\"top\"><small>" + tight.of(node.parts[2]) + "</small></td>";
    if (!node.parts[1].parts.empty())
      made += "<td valign=\"bottom\"><small>" + tight.of(node.parts[1]) + "</small></td>";
    return made;
  }

  /// A bracket as high as its contents: square ones and bars are borders of a cell, others large letters.
  static std::string bracket(const std::string& text, bool opens) {
    if (text.empty()) return {};
    if (text == "[" || text == "]") return opens ? edge("open") : edge("close");
    if (text == "|" || text == "‖") return edge("bar");
    return cell(tall(text));
  }
  static std::string edge(const std::string& kind) { return "<td class=\"" + kind + "\" width=\"4\"></td>"; }

  std::string grid(const TexNode& node) const {
    const bool is_plain = node.text == "matrix" || node.text == "aligned";
    std::string made = "<td><table class=\"grid\"" + kTable + ">";
    for (std::size_t i = 0; i < node.parts.size(); ++i) {
      if (i % node.columns == 0) made += "<tr>";
      const char* side = node.text == "cases"        ? "left"
                         : node.text != "aligned"    ? "center"
                         : i % node.columns % 2 == 0 ? "right"
                                                     : "left";
      made += std::string("<td class=\"entry\" align=\"") + side + "\">" + box(node.parts[i]) + "</td>";
      if ((i + 1) % node.columns == 0) made += "</tr>";
    }
    made += "</table></td>";
    if (is_plain) return made;
    if (node.text == "cases") return edge("open") + made;
    return node.text == "vmatrix" ? edge("bar") + made + edge("bar") : edge("open") + made + edge("close");
  }

  Line line_{"\u00a0"};
};

}  // namespace

std::string texToHtml(const TexNode& formula, bool display) {
  if (!display) return "<span class=\"formula\">" + Line(" ").of(formula) + "</span>";
  return "<table class=\"formula\" align=\"center\"" + kTable + "><tr>" + Display().cells(formula) + "</tr></table>\n";
}

std::string texToText(const TexNode& formula) {
  const std::string html = Line(" ").of(formula);
  constexpr std::array<std::pair<std::string_view, char>, 4> kEntities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&amp;", '&'}}};
  std::string text;
  for (std::size_t at = 0; at < html.size(); ++at) {
    if (html[at] == '<') {
      at = html.find('>', at);
      continue;
    }
    const auto is_here = [&](const auto& entity) { return html.compare(at, entity.first.size(), entity.first) == 0; };
    const auto* const entity = std::find_if(kEntities.begin(), kEntities.end(), is_here);
    text += entity == kEntities.end() ? html[at] : entity->second;
    if (entity != kEntities.end()) at += entity->first.size() - 1;
  }
  return text;
}

}  // namespace underact::page
