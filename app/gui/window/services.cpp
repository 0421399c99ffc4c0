#include "app/gui/window/services.h"

#include <QMainWindow>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/arms/second_arm.h"
#include "app/gui/feature/status_line.h"
#include "app/gui/files/load_strip.h"
#include "app/gui/files/scene_files.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/remark.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/arm_in_use.h"
#include "app/gui/model/player.h"
#include "app/gui/model/recording.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/model/window_scene.h"
#include "app/gui/view/drawn_mesh.h"
#include "app/gui/view/hand.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/view/stylus_key.h"
#include "core/arm/preset.h"
#include "core/scene/scene_arm.h"
#include "device/simulated_arm.h"
#include "device/simulated_run.h"

namespace underact::gui {

Services::Services(const WindowParts& given, const Settings& settings, QMainWindow* owner)
    : window(owner),
      host(given.host),
      actions(new Actions(owner)),
      document(new Document(given.host, owner)),
      recent(new RecentFiles(owner)),
      loads(new LoadStrip(owner)),
      files(new SceneFiles(*document, *recent, *loads, owner)),
      view(new SceneView(owner)),
      view_memory(std::make_unique<ViewMemory>(*view)),
      player(new Player(given.host, *document, given.replay, makeDrawnMeshes, owner)),
      recording(new Recording(given.host, owner)),
      steered(new WindowScene({given.host, *document, *player, *recording, *actions}, owner)),
      rate(new ServoRate(given.host, owner)),
      arms(new ArmChoice(given.host, *document, given.chosen, given.arm, owner)),
      second(new SecondArm(given.host, *arms, *view, owner)),
      arm_in_use(new ArmInUse(given.arm, settings.arm_model, owner)),
      hand(new Hand(view, given.arm, owner)),
      status(new StatusLine(given.host, arm::findPreset(arm::kDefaultArm)->continuous_force_N, owner)),
      where_it_stands(new Remark(owner)) {
  recent->set(settings.recent);
  view->setLayers(settings.layers);
  view->setForceLimit(arm::findPreset(arm::kDefaultArm)->continuous_force_N);
  buildMiddle();
  buildStatus(given);
  connectThem(given);
  recording->setRun([in_use = arm_in_use] {
    return device::provenanceOfPerson(in_use->hasSimulatedArm() ? &in_use->model() : nullptr);
  });
  if (given.arm != nullptr) new StylusKey(*given.arm, owner, view);
}

/// The view, and the progress strips below it.
void Services::buildMiddle() {
  view->setMinimumSize(320, 240);
  middle = new QVBoxLayout(new QWidget(window));
  middle->setContentsMargins(0, 0, 0, 0);
  middle->setSpacing(0);
  middle->addWidget(view, 1);
  middle->addWidget(loads);
  window->setCentralWidget(middle->parentWidget());
}

void Services::buildStatus(const WindowParts& given) {
  nameWidget(status, "status", QObject::tr("Status"));
  if (given.arm != nullptr) {
    const auto tell = [says = status, in_use = arm_in_use] {
      const sim::ArmModel& model = in_use->model();
      says->setArmModel(in_use->isMeasured() ? QString::fromStdString(model.name) : QString(),
                        QString::fromStdString(model.provenance));
    };
    QObject::connect(arm_in_use, &ArmInUse::changed, status, tell);
    tell();
  }
  window->statusBar()->setSizeGripEnabled(false);
  window->statusBar()->addPermanentWidget(status, 1);
}

void Services::connectThem(const WindowParts& given) {
  // Saved at once: a replay looks for its files beside the recently opened scenes.
  QObject::connect(recent, &RecentFiles::changed, window,
                   [files = recent] { QSettings().setValue("files/recent", files->paths()); });
  const auto integrate = [arm = given.arm, scenes = document] {
    if (arm == nullptr) return;
    arm->integrate(integrationOf(scenes->scene().simulation));
    arm->become(scene::armOf(scenes->scene()));
  };
  QObject::connect(document, &Document::opened, window, integrate);
  QObject::connect(document, &Document::edited, window, integrate);
  QObject::connect(document, &Document::opened, window, [this] {
    view->setScene(document->scene());
    actions->perform("layer.ghosts", false);  // they belong to the scene that was looked at
    view_memory->enter(document->showsRecorded() ? QString() : document->path());
    presentForceLimit();
  });
  QObject::connect(document, &Document::edited, window, [this] {
    view->followEdit(document->scene());
    presentForceLimit();
  });
  QObject::connect(rate, &ServoRate::changed, window, [this](int, int rate_hz) {
    status->measureAnew();
    second->setRate(rate_hz);
  });
  QObject::connect(arms, &ArmChoice::changed, window, [this] {
    hand->setAbsent(arms->simulated() == nullptr);
    status->presentDevice(player->isOpen());
    status->measureAnew();
  });
}

void Services::presentForceLimit() const {
  if (!document->isOpen()) return;
  const double limit_N = scene::armOf(document->scene()).continuous_force_N * host.forceShare();
  view->setForceLimit(limit_N);
  status->setForceLimit(limit_N);
}

FeatureParts Services::parts(const WindowParts& given, const Settings& settings, const std::vector<HelpPage>& pages,
                             std::function<QStringList()> busy_reason) const {
  return {.window = window,
          .middle = *middle,
          .servo = host,
          .control = ServoControl(host),
          .document = *document,
          .files = *files,
          .recent = *recent,
          .loads = *loads,
          .actions = *actions,
          .view = *view,
          .status = *status,
          .hand = *hand,
          .player = *player,
          .recording = *recording,
          .steered = *steered,
          .rate = *rate,
          .arm_in_use = *arm_in_use,
          .arms = *arms,
          .second = *second,
          .where_it_stands = *where_it_stands,
          .chosen = given.chosen,
          .hands = given.hands,
          .theme = given.theme,
          .settings = settings,
          .pages = pages,
          .busy_reason = std::move(busy_reason)};
}

void Services::remember(Settings& settings) const {
  view_memory->keep();
  settings.layers = view->layers();
  settings.layers.ghosts = false;
  settings.keeps_holding = hand->keepsHolding();
  settings.recent = recent->paths();
  settings.left_handed = document->isLeftHanded();
  settings.servo_rate_hz = rate->chosen().value_or(settings.servo_rate_hz);
  settings.arm_model = arm_in_use->text();
}

}  // namespace underact::gui
