#pragma once
#include <string>
#include <string_view>

namespace underact::sweep {

/// 32 hexadecimal digits of what computes the rows: this program, and the libraries of mathematics that it was started
/// with. Another build has others, also where its version is the same. By the linker's build ids, which neither strip
/// nor an installation changes; of a program without one, by its bytes.
const std::string& buildOf();

/// 32 hexadecimal digits that tell contents apart, also those that differ by damage; no defence against forgery.
std::string checksumOf(std::string_view bytes);

}  // namespace underact::sweep
