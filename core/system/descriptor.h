#pragma once
#include <utility>

namespace underact::system {

/// What every program has open.
inline constexpr int kInput = 0, kOutput = 1, kErrors = 2;

/// What the system has opened for this process, by its number; closed with the object.
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
  /// The caller closes it.
  int release() { return std::exchange(number_, -1); }
  /// 0, or the system's reason: some file systems tell of a full disk only here.
  int close();
  /// Open on the same as that one, below 0: on nothing; not passed on to programs that are started.
  static Descriptor copyOf(int number);

 private:
  int number_ = -1;
};

}  // namespace underact::system
