#pragma once
#include <optional>
#include <string_view>

#include "core/base/sentence.h"

namespace underact::arm {

/// Where a text of XML is refused, and why.
struct XmlExcess {
  int line = 0;
  Sentence sentence;
};

/// The first place where tinyxml2 would take more than linear time: an element with more than 64 attributes, each of
/// which it compares with all before it, or a reference such as &#65; without an end, for which it searches the rest of
/// the value. None: it reads the text in linear time. Any bytes but zero are allowed. Cost: linear.
std::optional<XmlExcess> excessOf(std::string_view text);

}  // namespace underact::arm
