#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace underact::record {

// What the sources that use HDF5 share. None of our headers includes the library's: its hid_t is this.
using Handle = std::int64_t;

/// Initializes the library, which otherwise happens on first use: for a process that loses rights later. It then loads
/// no plugins. false: the library is not available.
bool startHdf5();

/// An identifier of the library, closed at the end.
class Id {
 public:
  using Close = int (*)(Handle);
  Id() = default;
  Id(Handle id, Close closer) : id_(id), close_(closer) {}
  Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Id& operator=(Id&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Id() { close(); }
  bool close() {
    const Handle id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
  }
  operator Handle() const { return id_; }
  bool isGood() const { return id_ >= 0; }

 private:
  Handle id_ = -1;
  Close close_ = nullptr;
};

/// Switches the library's own error output off: sentences are ours. It is per thread, so every entry point calls it.
void quiet();

/// An attribute of a file: text or a number.
struct Attribute {
  std::string name;
  std::variant<std::string, std::int64_t, double> value;
};

/// Whether a name in a group is the object itself, not a link to one that may be in another file.
bool isOwn(Handle group, std::string_view name);

bool writeAttribute(Handle object, const Attribute& attribute);

// None if it is missing, of another kind, or a text of more than a mebibyte.
std::optional<std::string> textAttribute(Handle object, std::string_view name);
std::optional<std::int64_t> integerAttribute(Handle object, std::string_view name);
std::optional<double> realAttribute(Handle object, std::string_view name);

}  // namespace underact::record
