#pragma once
#include <QWidget>
#include <optional>

#include "core/scene/description.h"

class QCheckBox;
class QComboBox;

namespace underact::gui {

class ValueRow;

/// How much of the stylus's turn goes into the target: the part of the Feel panel for a circle, cylinder or sphere.
class InfluenceSection : public QWidget {
  Q_OBJECT
 public:
  explicit InfluenceSection(QWidget* parent = nullptr);
  /// Another constraint: what was there last is forgotten. own: its influence as the file has it. has_axis: so there is
  /// something to blend about; a sphere has none.
  void begin(const std::optional<scene::Influence>& own, bool has_axis);
  /// now: as it holds; own: as the file has it; none: position only.
  void present(const std::optional<scene::Influence>& now, const std::optional<scene::Influence>& own);
  bool isHeld() const;
  /// What a switch asks for: off, or what was there last, or the file's own, or half and half.
  std::optional<scene::Influence> switched(bool on) const;

 signals:
  /// what: for the undo menu. fresh: a step of its own for undo.
  void changed(const std::optional<underact::scene::Influence>& wanted, const QString& what, bool fresh);

 private:
  void buildRows();

  scene::Influence shown_;  // the last that held
  QCheckBox* on_;
  QWidget* details_;
  ValueRow* t_ = nullptr;
  ValueRow* blend_ = nullptr;
  QComboBox* axis_ = nullptr;
};

}  // namespace underact::gui
