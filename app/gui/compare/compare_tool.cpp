#include "app/gui/compare/compare_tool.h"

#include <QAction>
#include <QBoxLayout>
#include <QMainWindow>
#include <QStringList>
#include <utility>

#include "app/gui/compare/compare_strip.h"
#include "app/gui/compare/difference_words.h"
#include "app/gui/compare/two_views.h"
#include "app/gui/files/scene_files.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/data_words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/scene_library.h"
#include "core/arm/preset.h"
#include "core/scene/difference.h"
#include "core/scene/mirror.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {
namespace {

constexpr int kFramesAFigure = 12;  // numbers that change more often cannot be read
constexpr qsizetype kMaxShown = 3;  // differences; the rest is in the tool tip

QString wordsOf(const scene::Difference& difference) {
  const DifferenceWords words = differenceWords(difference);
  return CompareTool::tr("%1: felt %2, other %3").arg(words.what, words.one, words.other);
}

}  // namespace

CompareTool::CompareTool(const FeatureParts& parts)
    : QObject(parts.window),
      parts_(parts),
      views_(new TwoViews(parts.view, parts.middle.parentWidget())),
      beside_(parts.servo) {
  addActions();
  strip_ = new CompareStrip(parts_.actions, parts.middle.parentWidget());
  parts.middle.insertWidget(0, views_, 1);  // now contains the view
  parts.middle.addWidget(strip_);
  connect(&parts.actions, &Actions::locked, this, [this] { setOn(false); });
  const auto show = [this] {
    if (!isOn()) return;
    if (parts_.document.isMirrored() == is_mirrored_)
      showScenes();
    else
      compareWith(scene::mirrored(beside_.scene()));  // both scenes are for the same hand
  };
  connect(&parts_.document, &Document::opened, this, show);
  connect(&parts_.document, &Document::edited, this, show);
}

CompareTool::~CompareTool() = default;

void CompareTool::addActions() {
  parts_.actions.add({"compare.on",
                      tr("&Compare two scenes"),
                      {},
                      tr("Opens a second view with the scene as it is now. Change gains, and compare the forces before "
                         "and after the change on the same motion."),
                      {},
                      {},
                      true},
                     [this](const QVariantList& on) {
                       setOn(on.value(0).toBool());
                       return isOn() == on.value(0).toBool();
                     });
  parts_.actions.add({"compare.swap",
                      tr("S&wap compared scenes"),
                      {},
                      tr("Makes the other scene the one that is felt; the felt scene moves to the second view.")},
                     [this](const QVariantList&) { return swap(); });
  parts_.actions.add({"compare.same",
                      tr("Compare with the scene as it is &now"),
                      {},
                      tr("Copies the felt scene, as it is now, to the second view.")},
                     [this](const QVariantList&) { return isOn() && compareWith(parts_.document.scene()); });
  parts_.actions.add(
      {"compare.open", tr("Compar&e with another scene…"), {}, tr("Opens a scene file in the second view.")},
      [this](const QVariantList& path) {
        if (!path.isEmpty()) return open(path.first().toString());
        chooseAndOpen();
        return true;
      });
  for (const char* name : {"compare.swap", "compare.same"}) parts_.actions.find(name)->setEnabled(false);
}

bool CompareTool::isOn() const {
  return views_->showsRight();
}

void CompareTool::setOn(bool on) {
  if (on == isOn() || (on && !parts_.document.isOpen())) return;
  views_->showRight(on);
  strip_->setVisible(on);
  for (const char* name : {"compare.swap", "compare.same"}) parts_.actions.find(name)->setEnabled(on);
  if (QAction* action = parts_.actions.find("compare.on"); action->isChecked() != on) action->setChecked(on);
  if (on) {
    compareWith(parts_.document.scene());
  } else {
    loading_.cancel();
    beside_.end();
  }
}

bool CompareTool::compareWith(const scene::Description& scene) {
  const Problems problems = beside_.setScene(scene);
  tell(sentencesOf(problems));
  if (!problems.empty()) return false;
  is_mirrored_ = parts_.document.isMirrored();
  SceneView& right = views_->right();
  right.setScene(scene);
  right.setForceLimit(scene::armOf(scene).continuous_force_N * parts_.servo.forceShare());
  showScenes();
  return true;
}

/// Same file: an edit that can be undone. Another file: it is opened, with the question about unsaved changes.
bool CompareTool::swap() {
  if (!isOn()) return false;
  const scene::Description felt = parts_.document.scene(), other = beside_.scene();
  if (other.file == felt.file) {
    const Problems problems = parts_.document.edit(other, tr("swap of compared scenes"), parts_.document.newGesture());
    tell(sentencesOf(problems));
    if (!problems.empty()) return false;
  } else if (!parts_.files.openLoaded(parts_.document.throughMirror(other))) {
    return false;
  }
  return compareWith(felt);
}

bool CompareTool::open(const QString& path) {
  setOn(true);
  if (!isOn()) return false;
  const Problems problems = loading_.begin(path);
  tell(sentencesOf(problems));
  takeLoaded();
  return problems.empty();
}

void CompareTool::chooseAndOpen() {
  askForFile(views_->window(), "dialog.compare_scene", tr("Scene to compare with"), sceneFolder(),
             tr("Scenes (*.json);;All files (*)"),
             [this](const QString& path) { parts_.actions.perform("compare.open", path); });
}

void CompareTool::takeLoaded() {
  const std::optional<SceneLoading::Loaded> loaded = loading_.take();
  if (!loaded || !isOn()) return;
  if (loaded->problems.empty())
    compareWith(parts_.document.throughMirror(loaded->scene));
  else
    tell(sentencesOf(loaded->problems));
}

void CompareTool::showScenes() {
  const scene::Description &felt = parts_.document.scene(), &other = beside_.scene();
  views_->setHeads(tr("You feel: %1").arg(sceneText(felt.title)), tr("For comparison: %1").arg(sceneText(other.title)));
  QStringList words;
  for (const scene::Difference& one : scene::differencesBetween(felt, other)) words << wordsOf(one);
  const QString shown = QStringList(words.mid(0, kMaxShown)).join("\n");
  const qsizetype more = words.size() - kMaxShown;
  strip_->setDifference(words.isEmpty()
                            ? tr("The two scenes are the same. Change gains, shape or method of the one you feel.")
                        : more > 0 ? tr("%1\nand %2 more").arg(shown).arg(more)
                                   : shown,
                        words.join("\n"));
}

void CompareTool::tell(const QString& sentence) {
  strip_->tell(sentence);
}

void CompareTool::add(const servo::TickRecord& record) {
  if (!beside_.isOn()) return;
  const Problems problems = beside_.add(record);
  if (!problems.empty()) tell(sentencesOf(problems));
}

void CompareTool::present(const servo::Snapshot& snapshot) {
  takeLoaded();
  if (!isOn()) return;
  views_->present();
  if (!beside_.isOn()) return;
  const servo::Snapshot& other = beside_.snapshot();
  if (other.ticks > 0 && snapshot.ticks > 0) views_->right().present(other);
  if (frames_++ % kFramesAFigure == 0) strip_->present(beside_.feltFigures(), beside_.figures());
}

void CompareTool::setTheme(const Theme& theme) {
  views_->setTheme(theme);
}

}  // namespace underact::gui
