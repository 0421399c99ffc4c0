#pragma once
#include <QHash>
#include <QImage>
#include <QTextBrowser>

#include "app/page/page.h"

namespace underact::gui {

/// A page of Markdown with formulas and pictures, in the colours of the palette. Links are emitted by asked(), except
/// web addresses: these are shown, and opened in a browser if the user agrees.
class PageView : public QTextBrowser {
  Q_OBJECT
 public:
  explicit PageView(QWidget* parent = nullptr);

  /// folder: base of relative paths to pictures and other pages.
  void showPage(const QString& markdown, const QString& folder);
  /// The page shown last: its headings and its errors.
  const page::Page& page() const { return page_; }
  /// The height that shows all of the page without scrolling.
  int contentHeight() const;
  /// In percent of the program's own font; 50 to 300.
  void setZoom(int percent);
  int zoom() const { return zoom_; }
  /// Marks every word that begins with one of these, ignoring case.
  void mark(const QStringList& words);
  /// Goes to the next or previous mark, wrapping around. false: there is none.
  bool toMark(bool next);
  /// Number of pictures still loading: they are read in another thread, and space is reserved for them.
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
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

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
  int width_ = 0;                 // the width that pictures were fitted to
  QHash<QUrl, QImage> pictures_;  // of this page, at the size shown
  int pictures_awaited_ = 0;
  int page_number_ = 0;  // counts pages shown, so that a late picture is not put into another page
};

}  // namespace underact::gui
