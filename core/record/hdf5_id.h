#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace underact::record {

// What the sources that use HDF5 share. No header of ours includes the library's: its hid_t is this.
using Handle = std::int64_t;

/// Initialises the library now, which it otherwise does at first use: for a process that loses rights later. No plugins
/// are loaded then. false: the library is not available.
bool startHdf5();

/// An identifier of the library, closed by the destructor.
class Id {
 public:
  /// A function of the library that closes an identifier; below 0: it could not.
  using Close = int (*)(Handle);
  Id() = default;
  /// id: taken over; below 0: none. closer: the function of the library that closes such an identifier.
  Id(Handle id, Close closer) : id_(id), close_(closer) {}
  /// Takes the identifier over; the other is left with none.
  Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  /// Moves it; the other gets this one's to close.
  Id& operator=(Id&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Id() { close(); }
  /// Closes it now. false: the library could not. Nothing to close: true.
  bool close() {
    const Handle id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
  }
  operator Handle() const { return id_; }
  /// Whether there is an identifier.
  bool isGood() const { return id_ >= 0; }

 private:
  Handle id_ = -1;
  Close close_ = nullptr;
};

/// Switches off the library's own error output, a setting of each thread, and its work at the exit, which it takes over
/// with the first call of any of its functions: so each entry point calls this first.
void quiet();

/// An attribute of a file: text or a number.
struct Attribute {
  std::string name;
  std::variant<std::string, std::int64_t, double> value;
};

/// Whether a name in a group is an object of this file, not a link to another one.
bool isOwn(Handle group, std::string_view name);

/// A new attribute of the object. false: the library refused.
bool writeAttribute(Handle object, const Attribute& attribute);

// None if it is missing, of another kind, or a text of more than a mebibyte.
std::optional<std::string> textAttribute(Handle object, std::string_view name);
std::optional<std::int64_t> integerAttribute(Handle object, std::string_view name);
std::optional<double> realAttribute(Handle object, std::string_view name);

}  // namespace underact::record
