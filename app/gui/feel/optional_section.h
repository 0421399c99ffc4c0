#pragma once
#include <QWidget>
#include <vector>

#include "core/scene/settings.h"

class QCheckBox;
class QVBoxLayout;

namespace underact::gui {

class Document;

/// A setting of a constraint, by its path from there on, and what it should be.
struct SettingWish {
  std::string path;
  scene::SettingValue value;
};

/// A part of a constraint that may be missing, as its friction: a switch, and what is there while it is on.
class OptionalSection : public QWidget {
  Q_OBJECT
 public:
  struct Looks {
    QString name;  // "panel.influence"
    QString title, title_tip;
    const char* switch_name;
    QString switch_text, switch_spoken, switch_tip;
    QString turned_on, turned_off;  // for the undo menu
    /// All of the part's settings, as a switch puts them where the file has none. The first is the one that it cannot
    /// be without.
    std::vector<SettingWish> easy;
  };
  OptionalSection(Looks looks, QWidget* parent);

  QWidget* details() { return details_; }
  QVBoxLayout* rows() { return rows_; }  // inside details()
  /// Below the switch, whether it is on or not.
  QVBoxLayout* column() { return column_; }

  /// Another constraint: what was there last is forgotten.
  void begin(const Document& document, std::size_t index);
  void present(const Document& document, std::size_t index);
  /// Whether the constraint has the part.
  bool isOn(const Document& document, std::size_t index) const;
  /// What a switch asks for: off, or what was there last, or the file's own, or an easy one.
  std::vector<SettingWish> switched(bool on) const;
  QString switchedWords(bool on) const { return on ? looks_.turned_on : looks_.turned_off; }

 signals:
  void switchAsked(bool on);

 private:
  Looks looks_;
  std::vector<SettingWish> last_;  // that held
  QVBoxLayout* column_;
  QCheckBox* on_;
  QWidget* details_;
  QVBoxLayout* rows_;
};

}  // namespace underact::gui
