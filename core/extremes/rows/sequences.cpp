#include "core/extremes/rows/sequences.h"

namespace underact::extremes {

Signal drawSignal(Input& input, int count) {
  const double rate_hz = input.number("rate_hz", [](Dice& dice) { return std::min(dice.power(0, 17), 1e5); });
  const double size = input.number("size", [](Dice& dice) { return dice.one(2) ? dice.power(-14, -3) : dice.scale(); });
  const double offset =
      input.number("offset", [&](Dice& dice) { return dice.one(2) ? 0.0 : size * dice.power(0, 20); });
  const double tremble = input.number("tremble", [](Dice& dice) { return dice.one(2) ? 0.0 : dice.between(0.0, 0.5); });
  const bool stands = input.choice("stands", 4) == 0;
  Dice dice(static_cast<std::uint64_t>(
      input.number("walk", [](Dice& drawn) { return static_cast<double>(drawn.below(std::size_t{1} << 40U)); })));
  Signal signal;
  Vec3 e_W = Vec3::Constant(offset);
  for (int i = 0; i < count; ++i) {
    if (!(stands && dice.one(2))) e_W += size * dice.inBox(dice.one(16) ? 16.0 : 1.0);
    if (dice.one(32)) e_W[static_cast<Eigen::Index>(dice.below(3))] = offset == 0.0 ? 5e-324 : offset;
    const double dt_s = (1.0 + tremble * dice.between(-1.0, 1.0)) / rate_hz;
    signal.dt_s.push_back(i == 0 || dice.one(64) ? 0.0 : dt_s);
    signal.e_W.push_back(e_W);
  }
  return signal;
}

}  // namespace underact::extremes
