#include <QCoreApplication>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <bit>

#include "app/gui/kit/words.h"
#include "app/gui/model/limit_names.h"
#include "app/gui/servo/sections.h"
#include "app/gui/servo/share_bar.h"

namespace underact::gui {
namespace {

QString forceText(double force_N) {
  return QObject::tr("%1 N").arg(numberText(force_N, 2));
}

QString agoText(double ago_s) {
  if (ago_s < 1.0) return QObject::tr("just now");
  return ago_s < 120.0 ? QObject::tr("last %1 s ago").arg(numberText(ago_s, 0))
                       : QObject::tr("last %1 min ago").arg(numberText(ago_s / 60.0, 0));
}

}  // namespace

LimitsSection::LimitsSection(QWidget* parent)
    : Section("limits", tr("Limits"), tr("How much each limit of the safety gate reduces the force."), parent,
              "servo") {
  ShareBar::Words words;
  words.widest_value = tr("−0.00 N");
  for (const LimitName& name : limitNames()) {
    const QString title = QCoreApplication::translate("limit", name.title);
    if (fontMetrics().horizontalAdvance(title) > fontMetrics().horizontalAdvance(words.widest_name))
      words.widest_name = title;
  }
  const auto add = [&](const QString& key, const QString& name, const QString& tip, bool with_note) {
    words.name = name;
    words.tip = tip;
    auto* bar = new ShareBar("panel.servo." + key, words, with_note, this);
    column().addWidget(bar);
    return bar;
  };
  for (const LimitName& name : limitNames()) {
    limits_.push_back({add(QString("limit.") + name.key, QCoreApplication::translate("limit", name.title),
                           QCoreApplication::translate("limit", name.tip), true)});
  }
  ramp_ = add("limit.ramp", tr("Ramp"),
              tr("After Start the force ramps up within 0.3 s, after Stop it ramps down within 0.05 s. The bar shows "
                 "the share that is held back."),
              false);
  const QString tip =
      tr("Estimated heat of motor %1, relative to that at its continuous force. Computed, not measured: heating is "
         "proportional to the torque squared, with a time constant of 60 s.");
  auto* heading = new QLabel(tr("Motor heat (estimated)"), this);
  heading->setProperty("role", "quiet");
  heading->setToolTip(tip.arg(tr("1, 2 or 3")));
  column().addWidget(heading);
  const QString names[] = {tr("1 turret"), tr("2 thigh"), tr("3 shin")};
  for (std::size_t motor = 0; motor < heat_.size(); ++motor) {
    heat_[motor] = add(QString("heat.%1").arg(motor + 1), names[motor], tip.arg(motor + 1), false);
  }
}

void LimitsSection::add(const servo::TickRecord& record) {
  if (!(record.level > 0.0) || record.limits == 0) return;  // there was no force to reduce
  const bool alone = std::popcount(record.limits) == 1;     // then the whole reduction is due to this limit
  for (std::size_t index = 0; index < limits_.size(); ++index) {
    if ((record.limits & limitNames()[index].bit) == 0U) continue;
    limits_[index].last_tick = record.tick;
    if (alone) limits_[index].max_N = std::max(limits_[index].max_N, record.cut_N);
  }
}

void LimitsSection::setRate(std::int64_t ticks, int was_hz, int is_hz) {
  for (Limit& limit : limits_) {
    if (limit.last_tick != 0) limit.last_tick = ticks - (ticks - limit.last_tick) * is_hz / was_hz;
  }
}

void LimitsSection::present(const servo::Snapshot& snapshot, int rate_hz) {
  const tick::TickReport& report = snapshot.report;
  const double sent_N = report.force.f_T_W().norm();
  for (std::size_t index = 0; index < limits_.size(); ++index) {
    const LimitName& name = limitNames()[index];
    Limit& limit = limits_[index];
    const bool whole = name.cut_N == nullptr;
    const double cut_N = whole || !(report.level > 0.0) ? 0.0 : report.cuts.*name.cut_N;
    const bool acts = whole ? report.cuts.frozen && snapshot.mode == servo::Mode::Running : cut_N > 0.0;
    limit.max_N = std::max(limit.max_N, cut_N);
    if (acts) limit.last_tick = snapshot.ticks;
    const double share = whole ? (acts ? 1.0 : 0.0) : cut_N > 0.0 ? cut_N / (cut_N + sent_N) : 0.0;
    limit.bar->present(share, whole ? (acts ? tr("released") : QString()) : acts ? forceText(-cut_N) : QString(), acts);
    const double ago_s = static_cast<double>(snapshot.ticks - limit.last_tick) / rate_hz;
    limit.bar->setNote(limit.last_tick == 0 ? tr("not active yet")
                       : whole              ? agoText(ago_s)
                                            : tr("%1, at most %2").arg(agoText(ago_s), forceText(limit.max_N)));
  }
  const bool on_its_way = report.level > 0.0 && report.level < 1.0;
  ramp_->present(1.0 - report.level, tr("%1 %").arg(numberText(-100.0 * (1.0 - report.level), 0)), on_its_way);
  for (std::size_t motor = 0; motor < heat_.size(); ++motor) {
    const double heat = report.heat[static_cast<Eigen::Index>(motor)];
    heat_[motor]->present(heat, tr("%1 %").arg(numberText(100.0 * heat, 0)), heat > 0.9);
  }
}

void LimitsSection::setTheme(const Theme& theme) {
  for (const Limit& limit : limits_) limit.bar->setTheme(theme);
  ramp_->setTheme(theme);
  for (ShareBar* bar : heat_) bar->setTheme(theme);
}

}  // namespace underact::gui
