#pragma once
#include <QWidget>
#include <optional>

#include "core/scene/settings.h"

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace underact::gui {

class ValueRow;

/// What of it holds, or what the file has.
struct SurfaceValues {
  std::optional<scene::Friction> friction;  // none: smooth
  std::optional<double> smooth_deg;         // none: it is no mesh
  std::optional<mesh::Search> search;       // none: there is none to choose
};

/// How the surface holds the stylus: its friction, and, of a mesh, how far its force may lean so that bends feel round,
/// and how its nearest point is sought. The part of the Feel panel for what one can slide along.
class SurfaceSection : public QWidget {
  Q_OBJECT
 public:
  explicit SurfaceSection(QWidget* parent = nullptr);
  /// Another constraint: what was there last is forgotten. own: its friction as the file has it.
  void begin(const std::optional<scene::Friction>& own);
  void present(const SurfaceValues& now, const SurfaceValues& own);
  bool isHeld() const;
  /// What a switch asks for: off, or what was there last, or the file's own, or that of wood.
  std::optional<scene::Friction> switched(bool on) const;

 signals:
  /// what: for the undo menu. fresh: a step of its own for undo.
  void frictionChanged(const std::optional<underact::scene::Friction>& wanted, const QString& what, bool fresh);
  /// Another setting, by its path from the constraint on.
  void asked(const std::string& path, const underact::scene::SettingValue& value, bool fresh);

 private:
  void buildRows();

  scene::Friction shown_;  // the last that held
  QCheckBox* on_;
  QWidget* details_;
  ValueRow* static_ = nullptr;
  ValueRow* dynamic_ = nullptr;
  ValueRow* smooth_;
  QWidget* search_line_;
  QComboBox* search_;
};

}  // namespace underact::gui
