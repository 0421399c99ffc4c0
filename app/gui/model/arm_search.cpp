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

ArmEntry nobody(const device::Driver& driver) {
  return {driver.key, ArmSearch::tr("%1: none is plugged in").arg(sentenceText(phrase(driver.name))), {}, {}};
}

}  // namespace

bool operator==(const ArmEntry& one, const ArmEntry& other) {
  return one.kind == other.kind && one.title == other.title && one.name == other.name &&
         std::equal(one.missing.begin(), one.missing.end(), other.missing.begin(), other.missing.end(), isSame);
}

std::vector<ArmEntry> searchArms() {
  std::vector<ArmEntry> entries;
  for (const device::Driver& driver : device::catalogue()) {
    const std::vector<device::Found> found = driver.search();
    if (found.empty()) entries.push_back(nobody(driver));
    for (const device::Found& one : found) {
      entries.push_back(
          {driver.key, sentenceText(one.title), QString::fromStdString(device::nameOf(driver, one)), one.missing});
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
