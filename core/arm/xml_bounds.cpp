#include "core/arm/xml_bounds.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/translate.h"

namespace underact::arm {
namespace {

constexpr std::size_t kMaxAttributes = 64;     // those of URDF have at most six
constexpr std::size_t kLongestReference = 12;  // "&#x0010FFFF;"

/// What begins like this is no element, and ends where the second text does.
constexpr std::pair<std::string_view, std::string_view> kOthers[] = {
    {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}};

/// The position behind the next `what` from `at`, or the end.
std::size_t behind(std::string_view text, std::string_view what, std::size_t at) {
  const std::size_t found = text.find(what, at);
  return found == std::string_view::npos ? text.size() : found + what.size();
}

/// The first reference by number in a value that does not end soon; npos: all end.
std::size_t endlessReference(std::string_view value) {
  for (std::size_t at = value.find("&#"); at != std::string_view::npos; at = value.find("&#", at + 1)) {
    if (value.substr(at, kLongestReference).find(';') == std::string_view::npos) return at;
  }
  return std::string_view::npos;
}

}  // namespace

std::optional<XmlExcess> excessOf(std::string_view text) {
  const auto at_line = [&](std::size_t at, Sentence sentence) {
    return XmlExcess{
        1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')),
        std::move(sentence)};
  };
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    const std::size_t start = at;
    const auto other = std::find_if(std::begin(kOthers), std::end(kOthers),
                                    [&](const auto& one) { return text.substr(at).starts_with(one.first); });
    if (other != std::end(kOthers)) {
      at = behind(text, other->second, at + other->first.size());
      continue;
    }
    std::size_t attributes = 0;
    for (++at; at < text.size() && text[at] != '>'; ++at) {
      if (text[at] != '"' && text[at] != '\'') continue;
      const std::size_t end = std::min(text.find(text[at], at + 1), text.size());
      if (const std::size_t odd = endlessReference(text.substr(at, end - at)); odd != std::string_view::npos)
        return at_line(at + odd, phrase(TRANSLATE_NOOP("problem", "A reference such as &#65; ends with a semicolon.")));
      if (++attributes > kMaxAttributes)
        return at_line(start, phrase(TRANSLATE_NOOP("problem", "An element can have at most 64 attributes.")));
      at = end;
    }
  }
  return {};
}

}  // namespace underact::arm
