#pragma once
#include <QWidget>
#include <optional>

#include "core/scene/description.h"

class QCheckBox;

namespace underact::gui {

class ValueRow;

/// How a curve leads the hand along it: the part of the Feel panel for curves.
class GuideSection : public QWidget {
  Q_OBJECT
 public:
  explicit GuideSection(QWidget* parent = nullptr);
  /// Another constraint: what was there last is forgotten. own: its guide as the file has it.
  void begin(const std::optional<scene::CurveGuide>& own);
  /// now: as it holds; own: as the file has it; none: nobody leads.
  void present(const std::optional<scene::CurveGuide>& now, const std::optional<scene::CurveGuide>& own);
  bool isHeld() const;
  /// What a switch asks for: off, or what was there last, or the file's own, or an easy one.
  std::optional<scene::CurveGuide> switched(bool on) const;

 signals:
  /// what: for the undo menu. fresh: a step of its own for undo.
  void changed(const std::optional<underact::scene::CurveGuide>& wanted, const QString& what, bool fresh);

 private:
  void buildRows();

  scene::CurveGuide shown_;  // the last that held
  QCheckBox* on_;
  QWidget* details_;
  QCheckBox* backwards_ = nullptr;
  ValueRow* speed_ = nullptr;
  ValueRow* t_ = nullptr;
  ValueRow* lead_ = nullptr;
};

}  // namespace underact::gui
