#pragma once
#include <QStringList>
#include <QWidget>

#include "app/gui/kit/page_print.h"
#include "app/guide/search.h"

class QLineEdit;
class QUrl;

namespace underact::gui {

class GuideList;

/// The user's guide: contents and search on the left, a page on the right. It is a separate window, so that a page can
/// be read while the servo runs.
class GuideWindow : public QWidget {
  Q_OBJECT
 public:
  /// zoom: of the pages, in percent.
  GuideWindow(guide::Guide guide, int zoom, QWidget* parent);

  /// place: "PAGE" or "PAGE#heading". false: there is no such page, and the current one stays.
  bool open(const QString& place);
  /// The current place; empty: nothing shown yet.
  QString place() const { return at_ < 0 ? QString() : places_[at_]; }
  int zoom() const;
  /// Puts the text into the search field.
  void search(const QString& words);
  /// The path of a file beside the pages.
  QString file(const QString& name) const;

 signals:
  /// A link to something other than a page: "scene:02_sphere", "lesson:...", "action:...".
  void asked(const QUrl& link);
  /// The page was saved as PDF.
  void saved(const QString& path);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QWidget* buildBar();
  void find(const QString& words);
  void go(int steps);
  bool present(const QString& place);
  void follow(const QUrl& link);
  PaperPage paper() const;
  bool doKey(int key, Qt::KeyboardModifiers modifiers, bool really);

  guide::Guide guide_;
  guide::Search search_;
  GuideList* list_;
  PageView* page_;
  QLineEdit* field_;
  QWidget *back_ = nullptr, *forward_ = nullptr;
  QStringList places_;
  qsizetype at_ = -1;  // in places_
};

}  // namespace underact::gui
