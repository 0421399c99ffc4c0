#include "app/gui/registration/registration_run.h"

#include <utility>

#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {

using registration::Touching;

void RegistrationRun::begin(std::vector<Vec3> points_D) {
  touching_.emplace(std::move(points_D));
  p_WT_.reset();
  told_.clear();
  emit changed();
}

void RegistrationRun::end() {
  touching_.reset();
  p_WT_.reset();
  told_.clear();
}

void RegistrationRun::add(const servo::TickRecord& record) {
  if (!touching_ || (record.input & servo::kHadSample) == 0 || !record.p_WT.allFinite()) return;
  p_WT_ = record.p_WT;
  const std::size_t mark = touching_->due();
  tell(touching_->add(record.time_ns, record.p_WT, (record.buttons & 1U) != 0), mark);
}

void RegistrationRun::press() {
  if (!touching_ || touching_->isHolding() || touching_->due() == touching_->points_D().size()) return;
  touching_->press();
  tell(Touching::Event::Began, touching_->due());
}

void RegistrationRun::touchAgain(std::size_t mark) {
  if (!touching_) return;
  touching_->choose(mark);
  told_.clear();
  emit changed();
}

void RegistrationRun::tell(Touching::Event event, std::size_t mark) {
  switch (event) {
    case Touching::Event::None:
      return;
    case Touching::Event::Began:
      told_ = tr("Hold the tip still.");
      break;
    case Touching::Event::Moved:
      told_ = tr("The tip moved by more than 1 mm while you held it. Rest it on reference point %1 and press again.")
                  .arg(mark + 1);
      break;
    case Touching::Event::Touched:
      told_ = tr("Reference point %1 has been touched; the spread of the tip was %2 mm.")
                  .arg(mark + 1)
                  .arg(numberText(touching_->held(mark)->spread_m * kMillimetrePerMetre, 2));
      break;
  }
  emit changed();
}

}  // namespace underact::gui
