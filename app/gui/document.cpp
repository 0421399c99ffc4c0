#include "app/gui/document.h"

#include <QFileInfo>

#include "core/scene/read.h"
#include "core/scene/write.h"

namespace underact::gui {

/// One step back or forth between two controls.
class ControlEdit : public QUndoCommand {
 public:
  ControlEdit(Document& document, std::size_t index, const scene::Control& before, const scene::Control& after,
              const QString& what, int gesture)
      : QUndoCommand(what), document_(document), index_(index), before_(before), after_(after), gesture_(gesture) {}
  int id() const override { return gesture_; }
  void undo() override { document_.put(index_, before_); }
  void redo() override {
    if (!done_)
      done_ = true;  // edit() has put it into effect: that is how it knew that it is allowed
    else
      document_.put(index_, after_);
  }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const ControlEdit*>(other);
    if (next->index_ != index_) return false;
    after_ = next->after_;
    setObsolete(before_ == after_);
    return true;
  }

 private:
  Document& document_;
  std::size_t index_;
  scene::Control before_, after_;
  int gesture_;
  bool done_ = false;
};

Document::Document(servo::Host& host, QObject* parent) : QObject(parent), host_(host), undo_(this) {
  connect(&undo_, &QUndoStack::cleanChanged, this, [this](bool clean) { emit modifiedChanged(!clean); });
}

Problems Document::open(const QString& path) {
  const QString file = QFileInfo(path).absoluteFilePath();
  Result<scene::Description> read = scene::readSceneFile(file.toStdString());
  if (!read) return read.problems();
  Problems problems = host_.load(read.value());
  if (!problems.empty()) return problems;
  original_ = std::move(read).value();
  path_ = file;
  undo_.clear();
  emit opened();
  return {};
}

Problems Document::saveAs(const QString& path) {
  Problems problems = scene::writeSceneFile(host_.scene(), path.toStdString());
  if (!problems.empty()) return problems;
  path_ = QFileInfo(path).absoluteFilePath();
  original_ = host_.scene();
  undo_.setClean();
  emit edited();  // the marks of the scene's own values have moved
  return {};
}

Problems Document::edit(std::size_t index, const scene::Control& control, const QString& what, int gesture) {
  const scene::Control before = scene::controlOf(host_.scene(), index);
  if (control == before) return {};
  Problems problems = host_.setControl(index, control);
  if (!problems.empty()) return problems;
  undo_.push(new ControlEdit(*this, index, before, control, what, gesture));
  emit edited();
  return {};
}

void Document::put(std::size_t index, const scene::Control& control) {
  // It was in effect before, so it cannot be refused; the panels show what holds in any case.
  static_cast<void>(host_.setControl(index, control));
  emit edited();
}

}  // namespace underact::gui
