#include "app/gui/files/load_strip.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <utility>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/problems_dialog.h"

namespace underact::gui {
namespace {

constexpr int kPollLoad_ms = 50;
constexpr int kSteps = 1000;  // of the bar

}  // namespace

struct LoadStrip::Load {
  Load(QString what_is_loaded, Work work, Done when_done)
      : what(std::move(what_is_loaded)),
        done(std::move(when_done)),
        background([this, work = std::move(work)](WorkState& state) {
          TaskMonitor monitor;
          monitor.cancelled = &state.cancelled;
          monitor.progress = [this, &state](const char* now, double share) {
            step = now;
            state.share = share;
          };
          work(monitor);
          return true;
        }) {}
  QString what;
  Done done;
  std::atomic<const char*> step{""};  // a Watch's texts are static
  Background<bool> background;
};

LoadStrip::LoadStrip(QWidget* parent)
    : QWidget(parent),
      told_(messageLabel("load.told", tr("File that is being loaded"), "quiet", this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setObjectName("load");
  bar_->setObjectName("load.progress");
  bar_->setAccessibleName(tr("Progress"));
  bar_->setRange(0, kSteps);
  bar_->setMaximumWidth(28 * fontMetrics().averageCharWidth());
  cancel_->setObjectName("load.cancel");
  cancel_->setAccessibleName(tr("Cancel loading"));
  cancel_->setToolTip(tr("Cancels loading. The scene is not changed."));
  cancel_->setFocusPolicy(Qt::StrongFocus);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 4, 12, 4);
  row->setSpacing(8);
  row->addWidget(told_, 1);
  row->addWidget(bar_, 1);
  row->addWidget(cancel_);
  hide();
  poll_timer_.setInterval(kPollLoad_ms);
  connect(&poll_timer_, &QTimer::timeout, this, &LoadStrip::poll);
  connect(cancel_, &QPushButton::clicked, this, &LoadStrip::cancel);
}

LoadStrip::~LoadStrip() = default;

void LoadStrip::begin(const QString& what, Work work, Done done) {
  if (load_ != nullptr) cancel();
  closeProblems();
  load_ = std::make_unique<Load>(what, std::move(work), std::move(done));
  show({}, 0.0);
  setVisible(true);
  poll_timer_.start();
}

void LoadStrip::cancel() {
  if (load_ == nullptr) return;
  load_->background.cancel();
  leaving_.push_back(std::move(load_));
  hide();
  emit cancelled();
}

void LoadStrip::show(const QString& step, double share) {
  told_->setText(step.isEmpty() ? load_->what : tr("%1: %2").arg(load_->what, step.left(1).toLower() + step.mid(1)));
  bar_->setValue(static_cast<int>(share * kSteps));
}

void LoadStrip::poll() {
  std::erase_if(leaving_, [](const std::unique_ptr<Load>& one) { return one->background.take().has_value(); });
  if (load_ == nullptr) {
    if (leaving_.empty()) poll_timer_.stop();
    return;
  }
  show(QCoreApplication::translate("step of work", load_->step), load_->background.share());
  if (!load_->background.take()) return;
  const std::unique_ptr<Load> ready = std::move(load_);
  hide();
  ready->done();  // it may begin another load
}

}  // namespace underact::gui
