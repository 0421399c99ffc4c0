#include "app/gui/kit/shipped.h"

#include <QLabel>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/words.h"

namespace underact::gui {

QString shippedFolder(system::Resource resource) {
  const system::SearchRoots from = system::searchRoots();
  const Result<std::string> found = system::findResource(resource, from);
  if (found) return QString::fromStdString(found.value());
  const std::vector<std::string> places = searchFolders(resource, from);
  return places.empty() ? QString("/") : QString::fromStdString(places.front());
}

QString notFoundReason(system::Resource resource) {
  const Result<std::string> found = system::findResource(resource);
  return found ? QString() : sentencesOf(found.problems());
}

QLabel* notFoundLabel(system::Resource resource, const char* name, const QString& spoken, QWidget* parent) {
  QLabel* const label = messageLabel(name, spoken, "amber", parent);
  showMessage(label, notFoundReason(resource));
  return label;
}

}  // namespace underact::gui
