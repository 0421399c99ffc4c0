#pragma once
#include <QWidget>
#include <array>

#include "core/scene/settings.h"

class QComboBox;
class QFormLayout;

namespace underact::gui {

class Section;
class ValueRow;

/// How the rate of the error is found, and whether the energy is watched: the part of the Feel panel that is folded
/// away until it is asked for.
class RateSection : public QWidget {
  Q_OBJECT
 public:
  explicit RateSection(QWidget* parent = nullptr);
  /// now: as it holds; own: as the file has it.
  void present(const scene::Control& now, const scene::Control& own);
  bool isHeld() const;

 signals:
  /// A setting, by its path from the constraint on. fresh: a step of its own for undo.
  void asked(const std::string& path, const underact::scene::SettingValue& value, bool fresh);

 private:
  void buildRows();

  scene::Velocity shown_;  // the last that held
  Section* section_;
  QFormLayout* choices_;
  QComboBox* filter_;
  QComboBox* passivity_;
  std::array<ValueRow*, std::variant_size_v<scene::Velocity>> settings_{};  // the main one of each filter; null: none
};

}  // namespace underact::gui
