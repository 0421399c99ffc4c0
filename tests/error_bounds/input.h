#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "tests/error_bounds/dice.h"

namespace underact::error_bounds {

/// The numbers of one case, each with its name: drawn, or given. All input of the code under test goes through here, so
/// that a stored case consists of these numbers, not of a seed, and stays the same case when the draws change.
class Input {
 public:
  /// A case that is drawn from a seed; its numbers are kept as they are drawn.
  explicit Input(std::uint64_t seed) : dice_(seed) {}
  /// A case from the numbers that numbers() of an earlier one gave, in the order in which they are asked for.
  explicit Input(std::vector<double> given) : dice_(0), numbers_(std::move(given)), is_given_(true) {}

  /// draw(dice) gives the number; it is not called where the numbers are given.
  template <class Draw>
  double number(std::string_view name, const Draw& draw) {
    name_ += (name_.empty() ? "" : " ") + std::string(name);
    return next([&] { return static_cast<double>(draw(dice_)); });
  }
  /// Three numbers, "name.x" and so on; draw(dice) gives a Vec3.
  template <class Draw>
  Vec3 vector(std::string_view name, const Draw& draw) {
    const Vec3 drawn = is_given_ ? Vec3(Vec3::Zero()) : Vec3(draw(dice_));
    return {part(name, ".x", drawn.x()), part(name, ".y", drawn.y()), part(name, ".z", drawn.z())};
  }
  /// Nine numbers, column by column; draw(dice) gives a Mat3.
  template <class Draw>
  Mat3 matrix(std::string_view name, const Draw& draw) {
    const Mat3 drawn = is_given_ ? Mat3(Mat3::Zero()) : Mat3(draw(dice_));
    Mat3 taken;
    for (Eigen::Index column = 0; column < 3; ++column) {
      const Vec3 one = drawn.col(column);
      taken.col(column) = vector(std::string(name) + std::to_string(column), [&](Dice&) { return one; });
    }
    return taken;
  }
  /// A whole number from 0 to count - 1.
  template <class Draw>
  std::size_t choice(std::string_view name, std::size_t count, const Draw& draw) {
    const double drawn = number(name, [&](Dice& dice) { return static_cast<double>(draw(dice)); });
    return drawn >= 0.0 && drawn < static_cast<double>(count) ? static_cast<std::size_t>(drawn) : 0;
  }
  std::size_t choice(std::string_view name, std::size_t count) {
    return choice(name, count, [count](Dice& dice) { return dice.below(count); });
  }
  /// True or false, equally likely.
  bool flag(std::string_view name) { return choice(name, 2) == 1; }

  /// All numbers so far, or those given.
  const std::vector<double>& numbers() const { return numbers_; }
  /// Whether more or fewer numbers were asked for than given.
  bool isShort() const { return is_given_ && at_ != numbers_.size(); }
  /// "radius_m 0.5 p_WT.x 1e-300 ...", with as many digits as it takes.
  std::string words() const;

 private:
  template <class Draw>
  double next(const Draw& draw) {
    if (!is_given_) numbers_.push_back(draw());
    const double taken = at_ < numbers_.size() ? numbers_[at_] : 0.0;
    ++at_;
    return taken;
  }
  double part(std::string_view name, const char* which, double drawn) {
    return number(std::string(name) + which, [drawn](Dice&) { return drawn; });
  }

  Dice dice_;
  std::vector<double> numbers_;
  std::string name_;  // of all, in their order
  std::size_t at_ = 0;
  bool is_given_ = false;
};

/// A double as text that reads back as the same one: "0.1", "1e-300", "-0", "nan", "inf".
std::string textOf(double number);

}  // namespace underact::error_bounds
