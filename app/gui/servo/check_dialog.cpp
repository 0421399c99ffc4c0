#include "app/gui/servo/check_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

constexpr int kPollEvery_ms = 200;
constexpr double kGoodP99 = 1.3, kGoodP999 = 2.0;  // relative to the bare loop
constexpr int kMinSeconds = 2, kSeconds = 60, kMaxSeconds = 3600;

QStringList cellsOf(const servo::Percentiles& values) {
  QStringList cells;
  for (const double value_us : {values.p50_us, values.p99_us, values.p999_us, values.max_us})
    cells << numberText(value_us, value_us < 9.95 ? 1 : 0);
  return cells;
}

}  // namespace

QString verdictOf(const servo::CheckResult& result) {
  if (result.ticks == 0) return QObject::tr("Nothing was measured.");
  const double p99 = result.servo.p99_us / std::max(result.floor.p99_us, 1.0);
  const double p999 = result.servo.p999_us / std::max(result.floor.p999_us, 1.0);
  const QString times = QObject::tr("Its latency is %1 times that of a bare loop at p99, and %2 times at p99.9.")
                            .arg(numberText(p99, 2), numberText(p999, 2));
  const bool good = p99 <= kGoodP99 && p999 <= kGoodP999;
  return (good ? QObject::tr("The servo is as punctual as this machine allows. ")
               : QObject::tr("The servo is less punctual than this machine allows. ")) +
         times;
}

CheckDialog::CheckDialog(int rate_hz, const system::SchedulingRequest& wanted, QWidget* parent)
    : QDialog(parent),
      rate_hz_(rate_hz),
      wanted_(wanted),
      message_(new QLabel(this)),
      seconds_(new QSpinBox(this)),
      load_(new QCheckBox(tr("&Keep all cores busy"), this)),
      progress_(new QProgressBar(this)),
      table_(new QTableWidget(3, 4, this)),
      poll_timer_(new QTimer(this)) {
  setObjectName("dialog.check");
  setWindowTitle(tr("Servo check"));
  setModal(false);
  const QSize preferred(80 * fontMetrics().averageCharWidth(), 22 * fontMetrics().lineSpacing());
  resize(preferred.expandedTo({560, 360}));
  nameWidget(message_, "dialog.check.message", tr("Result"));
  message_->setWordWrap(true);
  message_->setText(
      tr("Measures the latency of the servo at %1 Hz and, in turn, that of a bare loop, which is the best this machine "
         "can do. The check uses a simulated arm of its own; your arm and the window keep running.")
          .arg(rate_hz));
  nameWidget(seconds_, "dialog.check.seconds", tr("Duration in seconds"));
  seconds_->setRange(kMinSeconds, kMaxSeconds);
  seconds_->setValue(kSeconds);
  seconds_->setSuffix(tr(" s"));
  load_->setObjectName("dialog.check.load");
  nameWidget(progress_, "dialog.check.progress", tr("Progress"));
  progress_->setRange(0, 1000);
  nameWidget(table_, "dialog.check.table", tr("Latency and tick time"));
  table_->setHorizontalHeaderLabels({tr("median"), tr("p99"), tr("p99.9"), tr("max")});
  table_->setVerticalHeaderLabels(
      {tr("bare loop, latency [µs]"), tr("servo, latency [µs]"), tr("servo, tick time [µs]")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  begin_ = buttons->addButton(tr("&Measure"), QDialogButtonBox::ActionRole);
  begin_->setObjectName("dialog.check.begin");
  begin_->setDefault(true);
  QPushButton* close = buttons->button(QDialogButtonBox::Close);
  close->setObjectName("dialog.check.close");
  close->setIcon({});
  auto* form = new QFormLayout;
  form->addRow(tr("&Duration"), seconds_);
  form->addRow(load_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(message_);
  column->addLayout(form);
  column->addWidget(progress_);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
  poll_timer_->setInterval(kPollEvery_ms);
  connect(poll_timer_, &QTimer::timeout, this, &CheckDialog::poll);
  connect(begin_, &QPushButton::clicked, this, [this] { run_ ? run_->cancel() : begin(); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

CheckDialog::~CheckDialog() = default;

QString CheckDialog::message() const {
  return message_->text();
}

void CheckDialog::begin() {
  servo::CheckOptions options;
  options.seconds = seconds_->value();
  options.rate_hz = rate_hz_;
  options.load = load_->isChecked();
  options.scheduling = wanted_;
  table_->clearContents();
  progress_->setValue(0);
  message_->setText(tr("Measuring the servo and a bare loop in turn, one second each."));
  seconds_->setEnabled(false);
  load_->setEnabled(false);
  begin_->setText(tr("E&nd now"));
  run_ = std::make_unique<CheckRun>(options);
  poll_timer_->start();
}

void CheckDialog::poll() {
  progress_->setValue(static_cast<int>(run_->share() * progress_->maximum()));
  if (const std::optional<servo::CheckResult> result = run_->takeResult()) {
    present(*result);
    end();
  }
}

void CheckDialog::end() {
  poll_timer_->stop();
  run_.reset();
  seconds_->setEnabled(true);
  load_->setEnabled(true);
  begin_->setText(tr("&Measure again"));
  progress_->setValue(progress_->maximum());
}

void CheckDialog::present(const servo::CheckResult& result) {
  int row = 0;
  for (const servo::Percentiles& values : {result.floor, result.servo, result.tick_time}) {
    const QStringList cells = cellsOf(values);
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    }
    ++row;
  }
  message_->setText(verdictOf(result) + QLatin1Char(' ') +
                    tr("%1 ticks in %2 s at %3 Hz, real time: %4. Late by a period or more: %5.")
                        .arg(result.ticks)
                        .arg(numberText(result.seconds, 0))
                        .arg(rate_hz_)
                        .arg(QString::fromStdString(result.scheduling.name))
                        .arg(result.late.total));
}

}  // namespace underact::gui
