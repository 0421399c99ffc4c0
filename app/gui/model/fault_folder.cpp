#include "app/gui/model/fault_folder.h"

#include <QStandardPaths>

namespace underact::gui {

QString faultFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/faults";
}

}  // namespace underact::gui
