#pragma once
#include <QImage>
#include <QProcess>
#include <QString>

namespace underact::gui {

/// The program ffmpeg, which gets pictures and writes the file beside its place, to be moved there when it is whole.
class FilmEncoder {
 public:
  FilmEncoder() = default;
  ~FilmEncoder();  // without finish(): nothing is left
  FilmEncoder(const FilmEncoder&) = delete;
  FilmEncoder& operator=(const FilmEncoder&) = delete;
  /// out: its ending says the format: webm, mp4 or gif. Why it cannot begin; empty: it did.
  QString begin(const QString& out, const QSize& size, int fps);
  /// Waits until the encoder has taken it. Why it did not; empty: it did.
  QString add(const QImage& picture);
  /// Waits for the end of the encoding. What went wrong; empty: the file is there.
  QString finish();

 private:
  QProcess process_;
  QString out_, part_;
};

/// Whether a film can be in this file.
bool isFilmName(const QString& out);

}  // namespace underact::gui
