#include "app/page/tex_tree.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "app/page/tex_words.h"
#include "core/json/text.h"

namespace underact::page {
namespace {

constexpr std::size_t kLongest = 4000;  // bytes: a formula, and not a page without its closing dollar
constexpr int kDeepestFormula = 24;
constexpr std::array<std::string_view, 6> kGrids{"matrix", "bmatrix", "pmatrix", "vmatrix", "cases", "aligned"};

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Reads the formula from left to right; a problem of its structure ends it, an unknown command does not.
class TexParser {
 public:
  TexParser(std::string_view tex, const SourceLocation& place) : tex_(tex), place_(place) {}

  Result<TexNode> parse() {
    if (tex_.size() > kLongest) return Problems{{"A formula is at most 4000 bytes long.", place_}};
    TexNode row = readRow();
    if (!stopped_ && at_ < tex_.size()) stop("There is a " + shownHere() + " too many in a formula.");
    if (!problems_.empty()) return problems_;
    return row;
  }

 private:
  void stop(std::string sentence) {
    if (!stopped_) problems_.push_back({std::move(sentence), place_});
    stopped_ = true;
    at_ = tex_.size();
  }
  std::string shownHere() const {
    return json::shown(tex_.substr(at_, tex_[at_] == '\\' ? 1 + nameAt(at_ + 1).size() : 1));
  }
  std::string_view nameAt(std::size_t from) const {
    std::size_t end = from;
    while (end < tex_.size() && isLetter(tex_[end])) end++;
    if (end == from && from < tex_.size()) end += std::max<std::size_t>(1, json::codePointLength(tex_, from));
    return tex_.substr(from, end - from);
  }
  void skipBlanks() {
    while (at_ < tex_.size() && std::isspace(static_cast<unsigned char>(tex_[at_])) != 0) at_++;
  }
  bool isAt(std::string_view text) const { return tex_.substr(at_, text.size()) == text; }
  bool take(std::string_view text) {
    skipBlanks();
    if (!isAt(text)) return false;
    at_ += text.size();
    return true;
  }

  /// Up to the end of a row: a brace, the next cell or row, \right, \end.
  TexNode readRow() {
    TexNode row;
    for (skipBlanks(); at_ < tex_.size(); skipBlanks()) {
      if (tex_[at_] == '}' || tex_[at_] == '&' || isAt("\\\\")) break;
      if (tex_[at_] == '\\' && (nameAt(at_ + 1) == "right" || nameAt(at_ + 1) == "end")) break;
      if (tex_[at_] == '_' || tex_[at_] == '^' || tex_[at_] == '\'')
        readScript(row);
      else
        row.parts.push_back(readAtom());
    }
    return row;
  }

  void readScript(TexNode& row) {
    if (row.parts.empty()) row.parts.push_back({});  // empty, as in TeX
    if (row.parts.back().kind != TexKind::Script)
      row.parts.back() = {TexKind::Script, {}, {}, {std::move(row.parts.back()), {}, {}}};
    TexNode& script = row.parts.back();
    const char mark = tex_[at_++];
    if (mark == '\'') {
      script.parts[2].parts.push_back({TexKind::Upright, "′"});
      return;
    }
    TexNode& place = script.parts[mark == '_' ? 1 : 2];
    if (!place.parts.empty() && place.parts.front().text != "′")
      return stop(std::string("A formula has two ") + mark + " in one place; use braces to show what each belongs to.");
    place.parts.push_back(readArgument());
  }

  /// The contents of braces, or one atom.
  TexNode readArgument() {
    skipBlanks();
    if (at_ >= tex_.size() || tex_[at_] == '}' || tex_[at_] == '&' || isAt("\\\\")) {
      stop("Something is missing in a formula, after " +
           json::shown(tex_.substr(at_ > 12 ? at_ - 12 : 0, std::min<std::size_t>(at_, 12))) + ".");
      return {};
    }
    return readAtom();
  }

  TexNode readGroup() {
    at_++;
    TexNode row = readRow();
    if (!take("}")) stop("A { in a formula has no }.");
    return row;
  }

  TexNode readAtom() {
    if (++depth_ > kDeepestFormula) stop("A formula is nested more than 24 deep.");
    TexNode atom = stopped_ ? TexNode() : readOne();
    depth_--;
    return atom;
  }

  TexNode readOne() {
    const char first = tex_[at_];
    if (first == '{') return readGroup();
    if (first == '\\') return readCommand();
    if (std::isdigit(static_cast<unsigned char>(first)) != 0) return readNumber();
    const std::size_t length = std::max<std::size_t>(1, json::codePointLength(tex_, at_));
    const std::string text(tex_.substr(at_, length));
    at_ += length;
    if (text == "-") return {TexKind::Operator, "−"};
    if (text == "+" || text == "=" || text == "<" || text == ">") return {TexKind::Operator, text};
    if (text == ",") return {TexKind::Upright, ", "};
    if (text == "~") return {TexKind::Space, "\u00a0"};
    return {isLetter(first) || length > 1 ? TexKind::Letter : TexKind::Upright, text};
  }

  TexNode readNumber() {
    const std::size_t from = at_;
    while (at_ < tex_.size() && (std::isdigit(static_cast<unsigned char>(tex_[at_])) != 0 || tex_[at_] == '.')) at_++;
    return {TexKind::Upright, std::string(tex_.substr(from, at_ - from))};
  }

  TexNode readCommand() {
    const std::string name(nameAt(at_ + 1));
    at_ += 1 + name.size();
    if (name == "frac" || name == "tfrac" || name == "dfrac") {
      TexNode above = readArgument();
      return {TexKind::Fraction, {}, {}, {std::move(above), readArgument()}};
    }
    if (name == "sqrt") return {TexKind::Root, {}, {}, {readArgument()}};
    if (name == "mathbf" || name == "boldsymbol") return {TexKind::Bold, {}, {}, {readArgument()}};
    if (name == "text" || name == "mathrm" || name == "operatorname") return {TexKind::Upright, readWords()};
    if (name == "left") return readFence();
    if (name == "begin") return readGrid();
    if (const std::string_view mark = texAccent(name); !mark.empty())
      return {TexKind::Accent, std::string(mark), {}, {readArgument()}};
    if (const TexWord* word = findTexWord(name)) return {word->kind, std::string(word->text)};
    const std::string near = json::nearestWord(name, texCommands());
    problems_.push_back(
        {"\\" + name + " is not a command that formulas support." + (near.empty() ? "" : " Is \\" + near + " meant?"),
         place_});
    return {};
  }

  /// Text in braces, unchanged.
  std::string readWords() {
    skipBlanks();
    const std::size_t end = tex_.find('}', at_);
    if (at_ >= tex_.size() || tex_[at_] != '{' || end == std::string_view::npos) {
      stop("Words in a formula need braces: \\text{if}.");
      return {};
    }
    const std::string words(tex_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    return words;
  }

  /// One bracket after \left or \right; a dot is none.
  std::string readBracket() {
    skipBlanks();
    if (at_ >= tex_.size()) {
      stop("After \\left and \\right there must be a bracket, or a dot for none.");
      return {};
    }
    const TexNode bracket = readAtom();
    return bracket.text == "." ? std::string() : bracket.text;
  }

  TexNode readFence() {
    TexNode fence{TexKind::Fence, readBracket()};
    fence.parts.push_back(readRow());
    if (take("\\right"))
      fence.right = readBracket();
    else
      stop("A \\left in a formula has no \\right.");
    return fence;
  }

  TexNode readGrid() {
    TexNode grid{TexKind::Grid, readWords()};
    if (!stopped_ && std::find(kGrids.begin(), kGrids.end(), grid.text) == kGrids.end())
      stop("There is no " + json::shown(grid.text) +
           " in formulas; there are matrix, bmatrix, pmatrix, vmatrix, cases "
           "and aligned.");
    std::vector<std::vector<TexNode>> rows(1);
    while (!stopped_) {
      rows.back().push_back(readRow());
      if (take("&")) continue;
      if (take("\\\\")) {
        rows.emplace_back();
        continue;
      }
      if (!take("\\end") || readWords() != grid.text) stop("A \\begin{" + grid.text + "} in a formula has no \\end.");
      break;
    }
    if (rows.size() > 1 && rows.back().size() == 1 && rows.back().front().parts.empty()) rows.pop_back();
    for (const auto& row : rows) grid.columns = std::max(grid.columns, row.size());
    cells_ += rows.size() * grid.columns;  // also those that only fill a row: a matrix in each cell of a matrix ...
    if (cells_ > kLongest) stop("A matrix has too many cells.");
    if (stopped_) return grid;
    for (auto& row : rows) {
      row.resize(grid.columns);
      std::move(row.begin(), row.end(), std::back_inserter(grid.parts));
    }
    return grid;
  }

  std::string_view tex_;
  SourceLocation place_;
  std::size_t at_ = 0, cells_ = 0;  // cells_: of all grids
  int depth_ = 0;
  bool stopped_ = false;
  Problems problems_;
};

}  // namespace

Result<TexNode> parseTex(std::string_view tex, const SourceLocation& place) {
  return TexParser(tex, place).parse();
}

}  // namespace underact::page
