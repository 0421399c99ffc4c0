#pragma once
#include <utility>

namespace underact::system {

/// The standard descriptors.
inline constexpr int kInput = 0, kOutput = 1, kErrors = 2;

/// A file descriptor of this process; closed with the object.
class Descriptor {
 public:
  Descriptor() = default;  // none
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  /// Takes it over; what this one had is closed with the other.
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  /// Whether there is one.
  bool isOpen() const { return number_ >= 0; }
  int number() const { return number_; }
  /// Gives it up: the caller closes it.
  int release() { return std::exchange(number_, -1); }
  /// Closes it. 0, or the system's error number: some file systems report a full disk only here.
  int close();
  /// A copy of a descriptor; below 0: none. Not inherited by programs that are started.
  static Descriptor copyOf(int number);

 private:
  int number_ = -1;
};

}  // namespace underact::system
