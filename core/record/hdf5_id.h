#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace underact::record {

// What the sources that speak with HDF5 share. The library's own header is in none of ours: its hid_t is this.
using Handle = std::int64_t;

/// Makes the library ready, which it does by itself when it is first used: for a process that may do less later on. It
/// loads no plugins then. false: it is not to be had.
bool startHdf5();

/// One identifier of the library's, closed at the end.
class Id {
 public:
  using Close = int (*)(Handle);
  Id() = default;
  /// id: taken over; below 0: none. closer: the function of the library that closes such an identifier.
  Id(Handle id, Close closer) : id_(id), close_(closer) {}
  /// Takes the identifier over; the other is left with none, or with this one's to close.
  Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
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

/// The library's own account of errors goes to nobody: sentences are ours. Kept by thread, so each way in calls it.
void quiet();

/// An attribute of a file: words or a number.
struct Attribute {
  std::string name;
  std::variant<std::string, std::int64_t, double> value;
};

/// Whether a name in a group is the object itself, and no link to one that may be in another file.
bool isOwn(Handle group, std::string_view name);

/// A new attribute of the object. false: the library refused.
bool writeAttribute(Handle object, const Attribute& attribute);

// None where it is not there, of another kind, or a text of more than a mebibyte.
std::optional<std::string> textAttribute(Handle object, std::string_view name);
std::optional<std::int64_t> integerAttribute(Handle object, std::string_view name);
std::optional<double> realAttribute(Handle object, std::string_view name);

}  // namespace underact::record
