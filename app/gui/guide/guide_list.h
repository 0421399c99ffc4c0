#pragma once
#include <QStackedWidget>

#include "app/guide/search.h"

class QListWidget;
class QListWidgetItem;
class QTreeWidget;

namespace underact::gui {

/// The list beside a page of the guide: the contents, or the search results.
class GuideList : public QStackedWidget {
  Q_OBJECT
 public:
  GuideList(const guide::Guide& guide, QWidget* parent);

  /// Marks the page in the contents.
  void showPage(const QString& name);
  /// Shows search results, the first one selected, or the contents if nothing was searched for.
  void showHits(const std::vector<guide::Hit>& hits, bool is_search);
  /// Opens the selected hit. false: there is none.
  bool openHit();
  /// Moves the selection by that many hits.
  void moveHit(int rows);

 signals:
  void chosen(const QString& place);

 private:
  void open(const QListWidgetItem* item);

  QTreeWidget* contents_;
  QListWidget* hits_;
};

}  // namespace underact::gui
