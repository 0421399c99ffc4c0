#pragma once
#include <string>

namespace underact::device::openhaptics {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace underact::device::openhaptics
