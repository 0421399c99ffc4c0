#include "app/gui/view/film_encoder.h"

#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <filesystem>
#include <system_error>

#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

constexpr int kStart_ms = 10'000, kPicture_ms = 60'000, kFinish_ms = 600'000;

// VP9 at a constant quality, in four parallel rows: no licence fee, and every browser plays it.
const QStringList kVp9{"-c:v", "libvpx-vp9", "-b:v", "0", "-crf", "30", "-row-mt", "1", "-pix_fmt", "yuv420p"};
// A palette of the film's own colours.
const QStringList kGif{"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse"};

QString formatOf(const QString& out) {
  return QFileInfo(out).suffix().toLower();
}

const QHash<QString, QStringList>& formats() {
  static const QHash<QString, QStringList> kAll{{"webm", kVp9}, {"mp4", kVp9}, {"gif", kGif}};
  return kAll;
}

QString missing() {
  return tr("The program ffmpeg, which encodes films, was not found. Install it (Debian: apt install ffmpeg).");
}

QString unwritable(const QString& out, const std::error_code& error) {
  return tr("%1 cannot be written: %2.").arg(out, QString::fromStdString(error.message()));
}

QString failed(QProcess& process) {
  process.waitForFinished(1000);
  const QString last = QString::fromLocal8Bit(process.readAll()).trimmed().section('\n', -1);
  return last.isEmpty() ? tr("ffmpeg ended before the film was complete.") : tr("ffmpeg says: %1").arg(last);
}

}  // namespace

bool isFilmName(const QString& out) {
  return formats().contains(formatOf(out));
}

FilmEncoder::~FilmEncoder() {
  if (process_.state() != QProcess::NotRunning) process_.kill();
  process_.waitForFinished(kStart_ms);
  if (!part_.isEmpty()) QFile::remove(part_);
}

QString FilmEncoder::begin(const QString& out, const QSize& size, int fps) {
  out_ = out;
  part_ = QFileInfo(out).path() + "/." + QFileInfo(out).fileName() + ".part";
  QStringList words{
      "-hide_banner", "-loglevel",          "error", "-y", "-f",
      "rawvideo",     "-pix_fmt",           "rgb24", "-s", QString("%1x%2").arg(size.width()).arg(size.height()),
      "-r",           QString::number(fps), "-i",    "-"};
  words << formats().value(formatOf(out)) << "-f" << formatOf(out) << part_;
  process_.setProcessChannelMode(QProcess::MergedChannels);
  process_.start("ffmpeg", words);
  if (process_.waitForStarted(kStart_ms)) return {};
  return missing();
}

QString FilmEncoder::add(const QImage& picture) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  for (int row = 0; row < rgb.height(); ++row)  // without what pads the rows of an image
    process_.write(reinterpret_cast<const char*>(rgb.constScanLine(row)), qint64{3} * rgb.width());
  while (process_.bytesToWrite() > 0) {
    if (!process_.waitForBytesWritten(kPicture_ms)) return failed(process_);
  }
  return {};
}

QString FilmEncoder::finish() {
  process_.closeWriteChannel();
  const bool has_ended = process_.waitForFinished(kFinish_ms);
  if (!has_ended || process_.exitStatus() != QProcess::NormalExit || process_.exitCode() != 0) return failed(process_);
  std::error_code error;
  std::filesystem::rename(part_.toStdString(), out_.toStdString(), error);
  if (error) return unwritable(out_, error);
  part_.clear();
  return {};
}

}  // namespace underact::gui
