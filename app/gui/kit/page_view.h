#pragma once
#include <QHash>
#include <QImage>
#include <QTextBrowser>
#include <memory>

#include "app/gui/kit/page_picture.h"
#include "app/page/page.h"

namespace underact::gui {

/// Who wrote a page: the program's own may be longer, and have pictures beside its folder.
enum class Author { Program, Stranger };

/// A page of Markdown with formulas and pictures, in the colours of the palette. Links are emitted by asked(), except
/// web addresses: these are shown, and opened in a browser if the user agrees.
class PageView : public QTextBrowser {
  Q_OBJECT
 public:
  explicit PageView(QWidget* parent = nullptr);

  /// folder: base of relative paths to pictures and other pages. A stranger's text is cut where it is longer than
  /// page::kStrangersPage; what is wrong with a picture is shown in its place.
  void showPage(const QString& markdown, const QString& folder, Author author = Author::Stranger);
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
  /// Number of pictures still loading: they are read in another thread. Space is reserved for the program's own.
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
  QImage awaitPicture(const QUrl& name);
  void putPicture(const QUrl& name, const Result<QImage>& read);
  QImage inWords(const Problems& problems) const;
  QSize roomForPicture() const;
  void follow(const QUrl& link);
  void confirmAddress(const QUrl& address);

  page::Page page_;
  QString folder_;
  Author author_ = Author::Program;
  QStringList marked_;
  int zoom_ = 100;
  int width_ = 0;                 // the width that pictures were fitted to
  QHash<QUrl, QImage> pictures_;  // of this page, at the size shown
  QHash<QUrl, QSize> sizes_;  // of those that have come before, so that the page does not jump where it is drawn anew
  int pictures_awaited_ = 0;
  std::shared_ptr<int> rendering_;  // gone with the page as shown, so that a late picture is not put into another one
};

}  // namespace underact::gui
