#pragma once
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/gui/kit/background.h"
#include "device/catalogue.h"

namespace underact::gui {

/// An arm in the list of what there is.
struct ArmEntry {
  QString kind;   // "wooden"
  QString title;  // "WoodenHaptics, serial 0042"
  QString name;   // "wooden:0042", as device::openDevice() takes it; empty: nothing of this kind is there
  std::vector<device::Missing> missing;
  bool isUsable() const { return !name.isEmpty() && missing.empty(); }
  friend bool operator==(const ArmEntry& one, const ArmEntry& other);
};

/// What is plugged in, of every kind that there is; a kind of which nothing is there has an entry that says so.
std::vector<ArmEntry> lookForArms();

/// Looks for arms in a thread of its own, since USB may take its time.
class ArmSearch : public QObject {
  Q_OBJECT
 public:
  explicit ArmSearch(QObject* parent);
  /// Now, if it is not at it. found() comes where something has changed.
  void look();
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
