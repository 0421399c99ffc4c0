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

/// Where a panel shows a setting. What it is, its unit, range, tip and words are those of the table of settings.
struct SettingLook {
  const char* path;  // from the constraint on: "/influence/t"
  const char* name;  // of the widget
  QString label;     // before it
  QString spoken;    // to a screen reader
  // Of a number in a row with a slider.
  QString widest = {};                                       // the longest label of it and its neighbours
  int steps_per_unit = 1, slider_steps = 100, decimals = 0;  // from 0 to the slider's end; typing goes beyond
  double most = 0.0;                                         // of what is typed, where it is not the table's
  // Of a choice.
  std::vector<std::string> order = {};  // of its words, where it is not the table's
};

/// The rows of a panel that show settings of a constraint and ask for other values of them. What a setting is shown by
/// is hidden where the constraint has none of it.
class SettingRows : public QObject {
  Q_OBJECT
 public:
  explicit SettingRows(QObject* parent) : QObject(parent) {}

  // Each makes a widget at the layout's end.
  ValueRow* addNumber(const SettingLook& look, QBoxLayout* into, QWidget* parent);
  ValueRow* addNumber(const SettingLook& look, QFormLayout* into, QWidget* parent);
  QComboBox* addChoice(const SettingLook& look, QFormLayout* into, QWidget* parent);
  QSpinBox* addWhole(const SettingLook& look, QFormLayout* into, QWidget* parent);
  /// With all its digits, to be typed.
  QLineEdit* addText(const SettingLook& look, QFormLayout* into, QWidget* parent);

  /// Shows what holds, and marks what the file has. is_idle: whether a setting does nothing there, so that it is
  /// hidden.
  void present(const Document& document, std::size_t index,
               const std::function<bool(const std::string&)>& is_idle = {});
  /// A slider is; the hand wins over what holds.
  bool isHeld() const;

 signals:
  /// path: from the constraint on. fresh: a step of its own for undo.
  void asked(const std::string& path, const underact::scene::SettingValue& value, bool fresh);
  /// What was typed is no number.
  void refused(const underact::Problems& problems);

 private:
  struct Row {
    std::string path;
    std::function<void(const scene::SettingValue& now, const scene::SettingValue& own)> present;
    std::function<void(bool on)> show;
    const ValueRow* slider = nullptr;
  };
  ValueRow* makeNumber(const SettingLook& look, QWidget* parent);

  std::vector<Row> rows_;
};

}  // namespace underact::gui
