#include "app/gui/replay/session_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/model/player.h"
#include "app/gui/plot/column_button.h"
#include "app/gui/plot/lateness_chart.h"
#include "app/gui/replay/session_plot.h"
#include "app/gui/view/scene_view.h"

namespace underact::gui {
namespace {

constexpr int kSessionColumns = 5, kLateness = 6;  // in the chooser, after those of SessionPlotKind

}  // namespace

SessionPanel::SessionPanel(const Parts& parts, QWidget* parent)
    : Panel(parent),
      parts_(parts),
      kind_(new QComboBox(this)),
      columns_(new ColumnButton("panel.session.columns", this)),
      pages_(new QStackedWidget(this)),
      nothing_(new QLabel(this)),
      plot_(new SessionPlot(this)),
      lateness_(new LatenessChart(this)) {
  nameWidget(kind_, "panel.session.kind", tr("Plot of the session"),
             tr("Selects a plot of the whole session. Click a plot against time to jump to that time."));
  kind_->addItems({tr("Error and force"), tr("Force against displacement"), tr("Influence angles"), tr("Energy"),
                   tr("Spectrum"), tr("Columns"), tr("Latency")});
  kind_->setFocusPolicy(Qt::StrongFocus);
  nothing_->setText(tr("Open a recorded session to see its plots here (Ctrl+Shift+O)."));
  nothing_->setAlignment(Qt::AlignCenter);
  nothing_->setWordWrap(true);
  nothing_->setProperty("role", "quiet");
  lateness_->setObjectName("panel.session.lateness");
  for (QWidget* page :
       {static_cast<QWidget*>(nothing_), static_cast<QWidget*>(plot_), static_cast<QWidget*>(lateness_)})
    pages_->addWidget(page);
  auto* label = new QLabel(tr("Plot of the &session"), this);
  label->setProperty("role", "quiet");
  label->setBuddy(kind_);
  auto* strip = new QHBoxLayout;
  strip->setContentsMargins(12, 4, 12, 0);
  strip->setSpacing(8);
  strip->addWidget(label);
  strip->addWidget(kind_);
  strip->addWidget(columns_);
  strip->addStretch(1);
  auto* column = tight<QVBoxLayout>(this, 0);
  column->addLayout(strip);
  column->addWidget(pages_, 1);
  connect(kind_, &QComboBox::currentIndexChanged, this, &SessionPanel::show);
  connect(&parts.player, &Player::opened, this, [this] {
    plot_->setSession(parts_.player.sharedData());
    lateness_->present(parts_.player.data().lateness(), 1e6 / parts_.player.recorded().rate_hz);
    parts_.view.setRecordedPath(parts_.player.data().path());
    readColumns();
    show();
  });
  connect(&parts.player, &Player::closed, this, [this] {
    plot_->setSession({});
    plot_->setColumns({});
    load_.reset();
    parts_.view.setRecordedPath({});
    show();
  });
  connect(columns_, &ColumnButton::changed, this, &SessionPanel::readColumns);
  parts.actions.addCommand("session.columns", [this](const QVariantList& names) {
    QStringList wanted;
    for (const QVariant& name : names) wanted << name.toString();
    columns_->choose(wanted);
    return columns_->names().size() == wanted.size();
  });
  connect(plot_, &SessionPlot::timeAsked, this,
          [this](double time_s) { parts_.actions.perform("replay.seek", time_s); });
  parts.actions.addCommand("session.plot", [this](const QVariantList& kind) {
    const int index = kind_->findText(kind.value(0).toString());
    if (index >= 0) kind_->setCurrentIndex(index);
    return index >= 0;
  });
  show();
}

void SessionPanel::show() {
  const int index = kind_->currentIndex();
  if (index != kLateness) plot_->setKind(static_cast<SessionPlotKind>(index));
  kind_->setEnabled(parts_.player.isOpen());
  columns_->setVisible(index == kSessionColumns);
  columns_->setEnabled(parts_.player.isOpen());
  pages_->setCurrentWidget(!parts_.player.isOpen() ? static_cast<QWidget*>(nothing_)
                           : index == kLateness    ? static_cast<QWidget*>(lateness_)
                                                   : plot_);
}

/// In another thread: a session is read from its beginning to its end for it.
void SessionPanel::readColumns() {
  load_.reset();
  plot_->setColumns({});
  if (!parts_.player.isOpen() || columns_->chosen().empty()) return;
  kind_->setCurrentIndex(kSessionColumns);
  load_ = std::make_unique<Background<Result<std::shared_ptr<const ColumnRows>>>>(
      [path = parts_.player.recorded().path, columns = columns_->chosen()](WorkState& state) {
        return gui::readColumns(path, columns, state);
      });
}

void SessionPanel::poll(const servo::Snapshot&) {
  if (load_ == nullptr) return;
  const std::optional<Result<std::shared_ptr<const ColumnRows>>> read = load_->take();
  if (!read) return;
  if (*read) plot_->setColumns(read->value());
  load_.reset();
}

void SessionPanel::present(const servo::Snapshot&) {
  if (!parts_.player.isOpen() || ++frame_ % kFramesAPlot != 0) return;
  if (!isSeen()) return;
  plot_->setCursor(parts_.player.secondsAt(parts_.player.row()));
}

void SessionPanel::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
  lateness_->setTheme(theme);
}

}  // namespace underact::gui
