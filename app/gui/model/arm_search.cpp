#include "app/gui/model/arm_search.h"

#include <algorithm>
#include <utility>

#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

constexpr int kTakeEvery_ms = 20;

bool isSame(const device::Missing& one, const device::Missing& other) {
  return one.sentence == other.sentence && one.command == other.command;
}

ArmEntry nobody(const device::Row& row) {
  return {row.key, ArmSearch::tr("%1: none is plugged in").arg(sentenceText(phrase(row.name))), {}, {}};
}

}  // namespace

bool operator==(const ArmEntry& one, const ArmEntry& other) {
  return one.kind == other.kind && one.title == other.title && one.name == other.name &&
         std::equal(one.missing.begin(), one.missing.end(), other.missing.begin(), other.missing.end(), isSame);
}

std::vector<ArmEntry> searchArms() {
  std::vector<ArmEntry> entries;
  for (const device::Row& row : device::catalogue()) {
    const std::vector<device::Found> found = row.search();
    if (found.empty()) entries.push_back(nobody(row));
    for (const device::Found& one : found) {
      entries.push_back(
          {row.key, sentenceText(one.title), QString::fromStdString(device::nameOf(row, one)), one.missing});
    }
  }
  return entries;
}

ArmSearch::ArmSearch(QObject* parent) : QObject(parent) {
  takes_.setInterval(kTakeEvery_ms);
  connect(&takes_, &QTimer::timeout, this, &ArmSearch::take);
}

void ArmSearch::search() {
  if (work_ != nullptr) return;
  work_ = std::make_unique<Background<std::vector<ArmEntry>>>([](WorkState&) { return searchArms(); });
  takes_.start();
}

void ArmSearch::take() {
  std::optional<std::vector<ArmEntry>> entries = work_ ? work_->take() : std::nullopt;
  if (!entries) return;
  work_.reset();
  takes_.stop();
  if (std::exchange(has_looked_, true) && *entries == entries_) return;
  entries_ = std::move(*entries);
  emit found();
}

}  // namespace underact::gui
