#include "core/record/tick_table.h"

#include "core/arm/forward.h"

namespace underact::record {

std::span<const Column> tickColumns(bool more_joints) {
  static constexpr std::array kAll =
      std::apply([](const auto&... field) { return std::array{field.column...}; }, kTickFields);
  return std::span(kAll).first(more_joints ? kAll.size() : kAll.size() - 1);
}

Eigen::Vector4d turnOf(const servo::TickRecord& record, const arm::Geometry& geometry) {
  if ((record.input & servo::kHadSample) == 0) return Eigen::Vector4d::Constant(kNotANumber);
  const Eigen::Quaterniond turn(arm::tipPose(geometry, record.q_rad).linear());
  return {turn.w(), turn.x(), turn.y(), turn.z()};
}

void pack(const servo::TickRecord& record, const arm::Geometry& geometry, Packer& packer, bool more_joints) {
  packFields(kFields<Tick>, record, packer, geometry);
  if (more_joints) packFields(std::tuple{kMoreJoints}, record, packer);
}

std::vector<double> numbersOf(const servo::TickRecord& record, const arm::Geometry& geometry) {
  std::vector<double> numbers;
  const auto add = [&](const auto& field) {
    eachNumber(
        field, record, [&](auto number) { numbers.push_back(scaled(field, number)); }, geometry);
  };
  std::apply([&add](const auto&... field) { (add(field), ...); }, kTickFields);
  return numbers;
}

bool hasMoreJoints(const Block& ticks) {
  return ticks.bytes.size() > static_cast<std::size_t>(ticks.rows) * rowBytes({{}, tickColumns()});
}

std::vector<servo::TickRecord> unpackTicks(const Block& block) {
  const bool more_joints = hasMoreJoints(block);
  std::vector<servo::TickRecord> records;
  records.reserve(static_cast<std::size_t>(block.rows));
  for (Unpacker unpacker(tickColumns(more_joints), block); !unpacker.isDone();) {
    servo::TickRecord& record = records.emplace_back();
    unpackFields(kFields<Tick>, unpacker, record);
    if (!more_joints) continue;
    unpackFields(std::tuple{kMoreJoints}, unpacker, record);
    record.joints = static_cast<int>(record.q_rad.size());
  }
  return records;
}

}  // namespace underact::record
