#pragma once
#include <QHash>
#include <QImage>
#include <QTextBrowser>

#include "app/page/page.h"

namespace underact::gui {

/// A page of Markdown with formulas and pictures, in the colours of the palette. What a link leads to is asked for, but
/// for addresses on the net: they are shown, and a browser opens them where that is wanted.
class PageView : public QTextBrowser {
  Q_OBJECT
 public:
  explicit PageView(QWidget* parent = nullptr);

  /// folder: what pictures and links to other pages are relative to.
  void showPage(const QString& markdown, const QString& folder);
  /// What was shown last: its headings, and what is wrong with it.
  const page::Page& page() const { return page_; }
  /// In percent of the program's own font; 50 to 300.
  void setZoom(int percent);
  int zoom() const { return zoom_; }
  /// Marks every word that begins with one of these, small and capital letters being the same.
  void mark(const QStringList& words);
  /// Goes to the next mark from here, or the one before; behind the last comes the first. false: there is none.
  bool toMark(bool next);
  /// Pictures that were asked for and have not come: they are read in another thread, and their place is free until
  /// then.
  int picturesAwaited() const { return pictures_awaited_; }

 signals:
  /// "scene:NAME", "lesson:NAME", "action:NAME" and "guide:PAGE#anchor"; a link to another page of the folder
  /// ("faults.md#stop") is "guide:faults#stop", one to a scene's file ("../../scenes/02_sphere.json")
  /// "scene:02_sphere".
  void asked(const QUrl& link);
  void zoomed(int percent);

 protected:
  QVariant loadResource(int type, const QUrl& name) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void render();
  void awaitPicture(const QUrl& name, const QString& path, const QSize& size);
  void putPicture(const QUrl& name, const QImage& picture);
  void follow(const QUrl& link);
  void confirmAddress(const QUrl& address);

  page::Page page_;
  QString folder_;
  QStringList marked_;
  int zoom_ = 100;
  int width_ = 0;                 // that pictures were fitted to
  QHash<QUrl, QImage> pictures_;  // of this page, as large as they are shown
  int pictures_awaited_ = 0;
  int page_number_ = 0;  // counts what was shown, so that a picture that comes late is not put into another page
};

}  // namespace underact::gui
