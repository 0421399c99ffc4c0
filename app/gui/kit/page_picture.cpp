#include "app/gui/kit/page_picture.h"

#include <QBuffer>
#include <QImageReader>
#include <filesystem>

#include "core/base/translate.h"
#include "core/system/named_file.h"

namespace underact::gui {
namespace {

constexpr std::uint64_t kLargest = std::uint64_t{8} << 20U;
constexpr qint64 kMaxPixels = 16'000'000;

Problems problemOf(Sentence sentence) {
  return {{std::move(sentence)}};
}

Result<QByteArray> bytesOf(const PagePicture& picture) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::canonical(picture.within, error);
  if (error) return problemOf(phrase(TRANSLATE_NOOP("problem", "A page without a folder has no pictures.")));
  const std::filesystem::path file = std::filesystem::weakly_canonical(picture.path, error);
  const std::filesystem::path inside = file.lexically_relative(folder);
  if (error || inside.empty() || *inside.begin() == "..")
    return problemOf(phrase(TRANSLATE_NOOP("problem", "A picture must be in the folder of the file that shows it.")));
  const Result<system::NamedFile> opened =
      system::NamedFile::open(file.string(), phrase(TRANSLATE_NOOP("problem", "a picture")));
  if (!opened) return opened.problems();
  const Result<std::string> read = opened.value().readAll(kLargest);
  return read ? Result<QByteArray>(QByteArray::fromStdString(read.value())) : read.problems();
}

/// Neither asks Qt what a file might be: an SVG names other files, which its reader opens.
const char* formatOf(const QByteArray& bytes) {
  return bytes.startsWith("\x89PNG") ? "png" : bytes.startsWith("\xFF\xD8\xFF") ? "jpeg" : nullptr;
}

}  // namespace

QSize fitted(const QSize& size, const QSize& room) {
  const bool fits = size.width() <= room.width() && size.height() <= room.height();
  return fits ? size : size.scaled(room, Qt::KeepAspectRatio).expandedTo({1, 1});
}

Result<QImage> readPagePicture(const PagePicture& picture, const QSize& room) {
  Result<QByteArray> bytes = bytesOf(picture);
  if (!bytes) return bytes.problems();
  QBuffer buffer(&bytes.value());
  const char* const format = formatOf(bytes.value());
  QImageReader reader(&buffer, format);
  reader.setAutoDetectImageFormat(false);
  const QSize size = format != nullptr && buffer.open(QIODevice::ReadOnly) ? reader.size() : QSize();
  if (qint64{size.width()} * size.height() > kMaxPixels)
    return problemOf(
        phrase(TRANSLATE_NOOP("problem", "The picture has %1 x %2 pixels; make it smaller than 16 megapixels."),
               {std::to_string(size.width()), std::to_string(size.height())}));
  const QImage image = size.isEmpty() ? QImage() : reader.read();
  if (image.isNull())
    return problemOf(phrase(TRANSLATE_NOOP("problem", "The picture is damaged, or neither PNG nor JPEG.")));
  return image.scaled(fitted(size, room), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace underact::gui
