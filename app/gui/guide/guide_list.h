#pragma once
#include <QStackedWidget>

#include "app/guide/search.h"

class QListWidget;
class QListWidgetItem;
class QTreeWidget;

namespace underact::gui {

/// What stands beside a page of the guide: the contents, or what a search has found.
class GuideList : public QStackedWidget {
  Q_OBJECT
 public:
  GuideList(const guide::Guide& guide, QWidget* parent);

  /// Marks the page in the contents.
  void showPage(const QString& name);
  /// What was found, the first of it chosen; nothing searched for: the contents.
  void showHits(const std::vector<guide::Hit>& hits, bool is_search);
  /// Opens the chosen hit. false: there is none.
  bool openHit();
  /// Chooses another hit, by that many rows.
  void moveHit(int rows);

 signals:
  void chosen(const QString& place);

 private:
  void open(const QListWidgetItem* item);

  QTreeWidget* contents_;
  QListWidget* hits_;
};

}  // namespace underact::gui
