#pragma once
#include <QWidget>
#include <optional>

#include "core/scene/description.h"

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace underact::gui {

class ValueRow;

/// How the surface holds the stylus: its friction, and, of a mesh that one is held to, how its nearest point is sought.
/// The part of the Feel panel for what one can slide along.
class SurfaceSection : public QWidget {
  Q_OBJECT
 public:
  explicit SurfaceSection(QWidget* parent = nullptr);
  /// Another constraint: what was there last is forgotten. own: its friction as the file has it.
  void begin(const std::optional<scene::Friction>& own);
  /// now: as it holds; own: as the file has it; none: smooth. search: none: there is none to choose.
  void present(const std::optional<scene::Friction>& now, const std::optional<scene::Friction>& own,
               const std::optional<mesh::Search>& search);
  bool isHeld() const;
  /// What a switch asks for: off, or what was there last, or the file's own, or that of wood.
  std::optional<scene::Friction> switched(bool on) const;

 signals:
  /// what: for the undo menu. fresh: a step of its own for undo.
  void frictionChanged(const std::optional<underact::scene::Friction>& wanted, const QString& what, bool fresh);
  void searchChanged(underact::mesh::Search search);

 private:
  void buildRows();

  scene::Friction shown_;  // the last that held
  QCheckBox* on_;
  QWidget* details_;
  ValueRow* static_ = nullptr;
  ValueRow* dynamic_ = nullptr;
  QWidget* search_line_;
  QComboBox* search_;
};

}  // namespace underact::gui
