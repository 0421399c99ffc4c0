#pragma once
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/gui/kit/background.h"
#include "device/catalogue.h"

namespace underact::gui {

/// An entry in the list of arms.
struct ArmEntry {
  QString kind;   // "wooden"
  QString title;  // "WoodenHaptics, serial 0042"
  QString name;   // "wooden:0042", as for device::openDevice(); empty: none of this kind is connected
  std::vector<device::Missing> missing;
  bool isUsable() const { return !name.isEmpty() && missing.empty(); }
  friend bool operator==(const ArmEntry& one, const ArmEntry& other);
};

/// The connected arms of every kind; a kind without any has an entry that says so.
std::vector<ArmEntry> searchArms();

/// Searches for arms in its own thread, since USB may be slow.
class ArmSearch : public QObject {
  Q_OBJECT
 public:
  explicit ArmSearch(QObject* parent);
  /// Starts a search unless one is running. Emits found() if something has changed.
  void search();
  const std::vector<ArmEntry>& entries() const { return entries_; }

 signals:
  void found();

 private:
  void take();

  std::unique_ptr<Background<std::vector<ArmEntry>>> work_;
  std::vector<ArmEntry> entries_;
  bool has_looked_ = false;
  QTimer takes_;
};

}  // namespace underact::gui
