#include "core/system/cores.h"

#include <charconv>

namespace underact::system {

std::optional<int> firstCore(std::string_view list) {
  int core = 0;
  const auto [end, error] = std::from_chars(list.data(), list.data() + list.size(), core);
  if (error != std::errc{} || core < 0) return {};
  const std::string_view rest(end, static_cast<std::size_t>(list.data() + list.size() - end));
  if (!rest.empty() && rest.find_first_of("-,\n") != 0) return {};
  return core;
}

}  // namespace underact::system
