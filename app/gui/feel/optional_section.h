#pragma once
#include <QWidget>
#include <vector>

#include "core/scene/settings.h"

class QCheckBox;
class QVBoxLayout;

namespace underact::gui {

class Document;

/// A setting of a constraint, by its path relative to the constraint, and its wanted value.
struct SettingChange {
  std::string path;
  scene::SettingValue value;
};

/// An optional part of a constraint, such as friction: a switch, and the settings while it is on.
class OptionalSection : public QWidget {
  Q_OBJECT
 public:
  struct Labels {
    QString name;  // "panel.influence"
    QString title, title_tip;
    const char* switch_name;
    QString switch_text, switch_spoken, switch_tip;
    QString turned_on, turned_off;  // for the undo menu
    /// All settings of the part, with the values that the switch sets if the file has none. The first is the required
    /// one.
    std::vector<SettingChange> easy;
  };
  OptionalSection(Labels looks, QWidget* parent);

  QWidget* details() { return details_; }
  QVBoxLayout* rows() { return rows_; }  // in details()
  /// The whole section: for rows that are visible whether the switch is on or off.
  QVBoxLayout* column() { return column_; }

  /// Shows another constraint; forgets the last values.
  void begin(const Document& document, std::size_t index);
  void present(const Document& document, std::size_t index);
  /// Whether the constraint has the part.
  bool isOn(const Document& document, std::size_t index) const;
  /// What the switch sets. Off: no value for the required setting; on: the last values, those of the file, or defaults.
  std::vector<SettingChange> switched(bool on) const;
  QString switchedWords(bool on) const { return on ? poll_timer_.turned_on : poll_timer_.turned_off; }

 signals:
  void switchAsked(bool on);

 private:
  Labels poll_timer_;
  std::vector<SettingChange> last_;  // values in effect
  QVBoxLayout* column_;
  QCheckBox* on_;
  QWidget* details_;
  QVBoxLayout* rows_;
};

}  // namespace underact::gui
