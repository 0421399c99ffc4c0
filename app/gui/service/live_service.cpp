#include "app/gui/service/live_service.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/window_scene.h"

namespace underact::gui {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds kIdle{20};      // nobody is connected
constexpr milliseconds kConnected{2};  // an answer is not kept waiting

}  // namespace

LiveService::LiveService(Actions& actions, WindowScene& scene, QMainWindow* window)
    : QObject(window), actions_(actions), scene_(scene) {
  addActions();
  addButton(window);
  connect(&beat_, &QTimer::timeout, this, &LiveService::step);
}

LiveService::~LiveService() {
  stop();
}

void LiveService::add(const servo::TickRecord& record) {
  if (service_) service_->add(record);
}

void LiveService::poll(const servo::Snapshot& snapshot) {
  const bool is_faulted = snapshot.mode == servo::Mode::Faulted;
  if (std::exchange(is_fault_told_, is_faulted) != is_faulted && is_faulted && service_)
    service_->add(snapshot.report.fault, snapshot.ticks);
}

Problems LiveService::start() {
  if (isOn()) return {};
  Result<serve::Server> server = serve::Server::open(serve::kDefaultPort, {});
  if (!server) server = serve::Server::open(0, {});  // another program or window has it
  if (!server) return server.problems();
  Result<serve::Token> token = serve::tokenFor({}, server.value().port());
  if (!token) return token.problems();
  server_ = std::move(server).value();
  token_.emplace(token.value());
  service_ = std::make_unique<serve::Service>(scene_, serve::ServiceOptions{token.value().text});
  server_->begin({service_.get()});
  beat_.start(kIdle);
  return {};
}

void LiveService::stop() {
  if (!isOn()) return;
  beat_.stop();
  server_->end();
  server_.reset();
  service_.reset();
  token_.reset();  // and its file
}

QString LiveService::address() const {
  return isOn() ? QString("ws://127.0.0.1:%1").arg(port()) : QString();
}

QString LiveService::tokenFile() const {
  return token_ ? QString::fromStdString(token_->token().file) : QString();
}

void LiveService::step() {
  if (is_stepping_ || !isOn()) return;  // a window that it makes wait has a loop of its own
  is_stepping_ = true;
  server_->step();
  is_stepping_ = false;
  const milliseconds wanted = service_->hasClients() ? kConnected : kIdle;
  if (beat_.intervalAsDuration() != wanted) beat_.setInterval(wanted);
}

void LiveService::addActions() {
  actions_.addCommand("service.hold", [this](const QVariantList&) { return hold(); });
  actions_.add({"service.on",
                tr("Let pro&grams steer"),
                {},
                tr("Lets other programs on this computer read and steer the scene. They need a token."),
                {},
                {},
                true},
               [this](const QVariantList& on) {
                 if (!on.value(0).toBool()) {
                   stop();
                   actions_.find("service.take_back")->setChecked(false);
                 } else if (const Problems problems = start(); !problems.empty()) {
                   actions_.perform("notice.tell", sentencesOf(problems));
                 } else {
                   actions_.perform("notice.tell", tr("Programs can steer the scene now, at %1.").arg(address()));
                 }
                 actions_.find("service.on")->setChecked(isOn());
                 actions_.find("service.take_back")->setEnabled(isOn());
                 return isOn() == on.value(0).toBool();
               });
  actions_
      .add({"service.take_back",
            tr("&Block programs"),
            {},
            tr("Ends what programs do to the scene. None can steer it until you turn this off."),
            {},
            {},
            true},
           [this](const QVariantList& on) {
             if (!isOn()) return false;
             service_->takeBack(on.value(0).toBool());
             return true;
           })
      ->setEnabled(false);
}

/// The person has stopped the servo: whoever steers may not start it again at once.
bool LiveService::hold() {
  if (!isOn() || service_->steeringClient().empty()) return false;
  actions_.perform("service.take_back", true);
  actions_.perform("notice.tell", tr("Stopped. Programs cannot steer until “Block programs” is turned off."));
  return true;
}

void LiveService::addButton(QMainWindow* window) {
  button_ = new QToolButton(window->statusBar());
  nameWidget(button_, "status.service", tr("Live service"), tr("The programs that listen to the scene or steer it."));
  button_->setPopupMode(QToolButton::InstantPopup);
  button_->setProperty("role", "menu");
  button_->setFocusPolicy(Qt::TabFocus);
  menu_ = new QMenu(button_);
  menu_->setObjectName("menu.service");
  menu_->setAccessibleName(tr("Live service"));
  connect(menu_, &QMenu::aboutToShow, this, &LiveService::fillMenu);
  button_->setMenu(menu_);
  button_->hide();
  window->statusBar()->addPermanentWidget(button_);
}

void LiveService::fillMenu() {
  menu_->clear();
  if (!isOn()) return;
  const auto copies = [this](const QString& text, const QString& what) {
    connect(menu_->addAction(text), &QAction::triggered, this, [this, what] {
      QApplication::clipboard()->setText(what);
      actions_.perform("notice.tell", tr("Copied: %1").arg(what));
    });
  };
  copies(tr("Copy the &address, %1").arg(address()), address());
  copies(tr("Copy the path of the &token file"), tokenFile());
  menu_->addSeparator();
  for (const std::string& name : service_->clientNames()) {
    const QString client = menuText(QString::fromStdString(name));
    menu_->addAction(name == service_->steeringClient() ? tr("%1 steers").arg(client) : tr("%1 listens").arg(client))
        ->setEnabled(false);
  }
  menu_->addSeparator();
  menu_->addAction(actions_.find("service.take_back"));
  menu_->addAction(actions_.find("service.on"));
}

QString LiveService::words() const {
  if (service_->isTakenBack()) return tr("You steer");
  const QString steers = QString::fromStdString(service_->steeringClient());
  if (!steers.isEmpty()) return tr("%1 steers").arg(steers.size() > 20 ? steers.left(19) + "…" : steers);
  const std::size_t count = service_->clientNames().size();
  if (count == 0) return tr("No program");
  return count == 1 ? tr("1 program listens") : tr("%1 programs listen").arg(count);
}

void LiveService::present(const servo::Snapshot&) {
  if (button_->isVisibleTo(button_->parentWidget()) != isOn()) button_->setVisible(isOn());
  if (!isOn()) return;
  const QString now = words();
  if (now == button_->text()) return;
  button_->setText(now);
  button_->setAccessibleName(tr("Live service: %1").arg(now));
}

}  // namespace underact::gui
