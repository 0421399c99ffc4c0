#pragma once
#include <QObject>
#include <QString>
#include <functional>
#include <vector>

#include "core/scene/settings.h"

class QBoxLayout;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;
class QWidget;

namespace underact::gui {

class Document;
class ValueRow;

/// How a panel shows a setting. Kind, unit, range, tip and words come from the table of settings.
struct SettingRowSpec {
  const char* path;  // relative to the constraint: "/influence/t"
  const char* name;  // object name of the widget
  QString label;     // text in front of it
  QString spoken;    // for a screen reader
  // For a number in a row with a slider.
  QString widest = {};                                       // the longest label among it and its neighbours
  int steps_per_unit = 1, slider_steps = 100, decimals = 0;  // from 0 to the slider's end; larger values can be typed
  double max = 0.0;                                          // maximum for typing, if it differs from the table's
  // For a choice.
  std::vector<std::string> order = {};  // of its words, if it differs from the table's
};

/// The rows of a panel that show and edit the settings of a constraint. The row of a setting that the constraint does
/// not have is hidden.
class SettingRows : public QObject {
  Q_OBJECT
 public:
  explicit SettingRows(QObject* parent) : QObject(parent) {}

  // Each appends a widget to the layout.
  ValueRow* addNumber(const SettingRowSpec& spec, QBoxLayout* into, QWidget* parent);
  ValueRow* addNumber(const SettingRowSpec& spec, QFormLayout* into, QWidget* parent);
  QComboBox* addChoice(const SettingRowSpec& spec, QFormLayout* into, QWidget* parent);
  QSpinBox* addWhole(const SettingRowSpec& spec, QFormLayout* into, QWidget* parent);
  /// A number to type, shown with all its digits.
  QLineEdit* addText(const SettingRowSpec& spec, QFormLayout* into, QWidget* parent);

  /// Shows the current values and marks those of the file. is_idle: whether a setting has no effect there and is
  /// hidden.
  void present(const Document& document, std::size_t index,
               const std::function<bool(const std::string&)>& is_idle = {});
  /// Whether a slider is being dragged: the drag wins over the current value.
  bool isHeld() const;

 signals:
  /// path: relative to the constraint. fresh: starts a new step of undo.
  void asked(const std::string& path, const underact::scene::SettingValue& value, bool fresh);
  /// The text typed is not a number.
  void refused(const underact::Problems& problems);

 private:
  struct SettingRow {
    std::string path;
    std::function<void(const scene::SettingValue& now, const scene::SettingValue& own)> present;
    std::function<void(bool on)> show;
    const ValueRow* slider = nullptr;
  };
  ValueRow* makeNumber(const SettingRowSpec& spec, QWidget* parent);

  std::vector<SettingRow> rows_;
};

}  // namespace underact::gui
