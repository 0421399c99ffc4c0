#pragma once
#include <string>
#include <string_view>

namespace underact::sweep {

/// 32 hexadecimal digits that identify what computes the rows: this program, and the mathematical libraries that it was
/// started with. They differ for another build, even of the same version. From the linker's build ids, which neither
/// strip nor an installation changes; for a program without one, from its bytes.
const std::string& buildOf();

/// 32 hexadecimal digits that detect different or damaged contents; no protection against forgery.
std::string checksumOf(std::string_view bytes);

}  // namespace underact::sweep
