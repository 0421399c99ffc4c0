#include "core/system/file.h"

#include <cerrno>

namespace underact::system {

int putInPlace(Descriptor made, const std::string& part, const std::string& path, std::string_view text, Lasting how) {
  if (!made.isOpen()) return errno;
  int reason = writeAll(made.number(), std::as_bytes(std::span(text)));
  if (reason == 0 && how == Lasting::OnDisk) reason = sync(made.number());
  if (const int late = made.close(); reason == 0) reason = late;
  if (reason == 0 && std::rename(part.c_str(), path.c_str()) != 0) reason = errno;
  if (reason != 0) std::remove(part.c_str());
  if (reason == 0 && how == Lasting::OnDisk) syncFolderOf(path);
  return reason;
}

}  // namespace underact::system
