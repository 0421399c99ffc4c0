#pragma once
#include <QImage>
#include <QSize>
#include <string>

#include "core/base/result.h"

namespace underact::gui {

/// A picture of a page. Others wrote the page: the picture must be a regular file in `within` or below, also where
/// links lead; PNG or JPEG; at most 8 MiB and 16 megapixels, which its header says before it is decoded. Never waits
/// for a pipe.
/// path: as the page gives it, behind the page's folder.
struct PagePicture {
  std::string within, path;
};

/// The picture, no larger than `room`. Any thread. Problems: one, for the reader of the page.
Result<QImage> readPagePicture(const PagePicture& picture, const QSize& room);

/// The size at which a picture of this size is shown.
QSize fitted(const QSize& size, const QSize& room);

}  // namespace underact::gui
