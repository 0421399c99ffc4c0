#include "core/curve/points.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/translate.h"
#include "core/json/text.h"

namespace underact::curve {
namespace {

constexpr std::size_t kLargestFile = std::size_t{256} << 20;
constexpr int kLinesBetweenLooks = 1 << 14;  // at the watch

bool isBlank(char c) {
  return c == ' ' || c == '\t';
}
bool isSeparator(char c) {
  return c == ',' || c == ';';
}

/// The number in a field, infinite where it overflows; none where it is not a number.
std::optional<double> numberOf(std::string_view field) {
  if (field.size() > 1 && field[0] == '+' && field[1] != '-') field.remove_prefix(1);  // from_chars takes no plus
  double number = 0.0;
  const char* end = field.data() + field.size();
  const std::from_chars_result read = std::from_chars(field.data(), end, number);
  if (read.ec == std::errc::invalid_argument || read.ptr != end) return std::nullopt;
  return read.ec == std::errc::result_out_of_range ? json::numberOf(field) : number;
}

/// One line, split into fields; beyond seven they are counted, not kept.
struct Fields {
  std::array<std::string_view, 7> text = {};
  std::size_t count = 0;
  bool has_gap = false;  // two separators with nothing between them
};

Fields fieldsOf(std::string_view line) {
  Fields fields;
  bool may_separate = false;
  for (std::size_t at = 0; at < line.size();) {
    if (isBlank(line[at])) {
      ++at;
    } else if (isSeparator(line[at])) {
      if (!may_separate) fields.has_gap = true;
      may_separate = false;
      ++at;
    } else {
      const std::size_t end = std::min(line.find_first_of(" \t,;", at), line.size());
      if (fields.count < fields.text.size()) fields.text[fields.count] = line.substr(at, end - at);
      ++fields.count;
      may_separate = true;
      at = end;
    }
  }
  return fields;
}

/// Whether the fields are names of columns: no number among them.
bool isHeader(const Fields& fields) {
  for (std::size_t i = 0; i < std::min(fields.count, fields.text.size()); ++i) {
    if (numberOf(fields.text[i])) return false;
  }
  return true;
}

/// Whether a colour follows the point or its intensity, three numbers from 0 to 1 or whole ones to 255. Not where a
/// comma may be a decimal one: within what other separators divide.
bool hasColour(const Fields& fields, std::string_view line) {
  if (fields.count != 6 && fields.count != 7) return false;
  for (std::size_t at = line.find(','); at < line.size() - 1; at = line.find(',', at + 1)) {
    if (!isBlank(line[at + 1]) && line.find_first_of(" \t;") != std::string_view::npos) return false;
  }
  const auto end = fields.text.begin() + static_cast<std::ptrdiff_t>(fields.count);
  return std::all_of(end - 3, end, [](std::string_view field) {
    const double share = numberOf(field).value_or(-1.0);
    return share >= 0.0 && (share <= 1.0 || (share <= 255.0 && share == std::floor(share)));
  });
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  /// Takes a line. False: further lines are not needed.
  bool take(std::string_view line) {
    ++line_;
    line = line.substr(0, line.find('#'));
    const Fields fields = fieldsOf(line);
    if (fields.count == 0 && !fields.has_gap) return true;
    const bool is_first = !begun_;
    begun_ = true;
    if (is_first && isHeader(fields)) return true;
    if (fields.count == 1 && count_ == 0 && !stated_ && (stated_ = numberOf(fields.text[0]))) {
      stated_line_ = line_;
      return true;
    }
    const bool has_colour = hasColour(fields, line);
    has_colours_ = has_colours_ || has_colour;
    const std::optional<Vec3> p = pointOf(fields, has_colour);
    if (!p) return problems_.size() < kMaxProblems;
    ++count_;
    if (!points_.empty() && points_.back() == *p) return true;
    if (points_.size() == kMaxPoints) {
      refuse(phrase(TRANSLATE_NOOP("problem", "The file has more than 1000000 points; remove every second one.")));
      return false;
    }
    points_.push_back(*p);
    return true;
  }

  Sentence note() const {
    if (!has_colours_ && !stated_) return {};
    return phrase(TRANSLATE_NOOP("problem", "Colours behind the points, or their number before them, were left out."));
  }

  Result<std::vector<Vec3>> finished() && {
    if (problems_.empty() && stated_ && *stated_ != static_cast<double>(count_)) {
      line_ = stated_line_;
      (void)pointOf({.count = 1}, false);  // then it is a point of one number
    }
    if (problems_.empty() && points_.empty())
      problems_.push_back({phrase(TRANSLATE_NOOP("problem", "The file has no points.")), {file_, 0, 0, ""}});
    if (!problems_.empty()) return std::move(problems_);
    return std::move(points_);
  }

 private:
  void refuse(const Sentence& sentence) { problems_.push_back({sentence, {file_, line_, 0, ""}}); }

  std::optional<Vec3> pointOf(const Fields& fields, bool has_colour) {
    if (fields.has_gap) {
      refuse(phrase(TRANSLATE_NOOP("problem", "There is nothing between two separators; a point is three numbers.")));
      return std::nullopt;
    }
    if (fields.count != 3 && !has_colour) {
      refuse(phrase(TRANSLATE_NOOP("problem", "A point is three numbers, not %1; use a point for decimals."),
                    {std::to_string(fields.count)}));
      return std::nullopt;
    }
    Vec3 p;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<double> number = numberOf(fields.text[i]);
      if (!number) {
        refuse(phrase(TRANSLATE_NOOP("problem", "%1 is not a number."), {json::shown(fields.text[i])}));
        return std::nullopt;
      }
      if (!std::isfinite(*number)) {
        refuse(phrase(TRANSLATE_NOOP("problem", "%1 is not a finite number."), {json::shown(fields.text[i])}));
        return std::nullopt;
      }
      p[static_cast<Eigen::Index>(i)] = *number;
    }
    return p;
  }

  const std::string& file_;
  int line_ = 0;
  std::optional<double> stated_;  // how many points there are, on that line
  int stated_line_ = 0;
  std::size_t count_ = 0;  // of points, those left out with them
  bool has_colours_ = false;
  bool begun_ = false;  // a line that is neither empty nor a comment has come
  std::vector<Vec3> points_;
  Problems problems_;
};

}  // namespace

Result<std::vector<Vec3>> parsePoints(std::string_view text, const std::string& file, const TaskMonitor& monitor,
                                      Sentence* note) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark, which some editors write
  Reader reader(file);
  int until_look = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (--until_look < 0) {
      if (monitor.isCancelled())
        return Problems{{phrase(TRANSLATE_NOOP("problem", "Reading was cancelled.")), {file, 0, 0, ""}}};
      monitor.report(TRANSLATE_NOOP("step of work", "reading points"),
                     static_cast<double>(at) / static_cast<double>(text.size()));
      until_look = kLinesBetweenLooks;
    }
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    if (!reader.take(text.substr(at, end - at))) break;
    at = text.substr(end).starts_with("\r\n") ? end + 2 : end + 1;
  }
  if (note != nullptr) *note = reader.note();
  return std::move(reader).finished();
}

Result<std::string> readPointsText(const std::string& path) {
  return json::readTextFile(path, phrase(TRANSLATE_NOOP("problem", "a curve")), kLargestFile);
}

Result<std::vector<Vec3>> readPoints(const std::string& path, const TaskMonitor& monitor) {
  const Result<std::string> text = readPointsText(path);
  if (!text) return text.problems();
  return parsePoints(text.value(), path, monitor);
}

}  // namespace underact::curve
