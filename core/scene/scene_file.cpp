#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/translate.h"
#include "core/json/text_file.h"
#include "core/scene/read.h"
#include "core/scene/write.h"

namespace underact::scene {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int get() const { return number_; }
  /// Some file systems tell of a full disk only here.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

std::string reason() {
  return std::generic_category().message(errno);
}

Problems problem(const std::string& path, Sentence sentence) {
  return {{std::move(sentence), {path, 0, 0, ""}}};
}

bool writeAll(const Descriptor& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file.get(), text.data(), text.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// The file itself where path is a link to it, so that the link stays a link.
std::string withoutLinks(const std::string& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  return error ? path : real.string();
}

}  // namespace

Result<Description> readSceneFile(const std::string& path) {
  const Result<std::string> text = json::readTextFile(path, said(TRANSLATE_NOOP("problem", "a scene")));
  if (!text) return text.problems();
  return readScene(text.value(), path);
}

Problems writeSceneFile(const Description& scene, const std::string& path, const std::optional<Teaching>& teaching) {
  const std::string target = withoutLinks(path);
  const std::string part = target + "." + std::to_string(::getpid()) + ".part";
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode))
    return problem(path, said(TRANSLATE_NOOP("problem", "This is a folder; a scene needs a file name.")));
  Descriptor file(::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.get() < 0)
    return problem(path, said(TRANSLATE_NOOP("problem", "The scene cannot be saved: %1."), {reason()}));
  if (exists) (void)!::fchmod(file.get(), old.st_mode & 07777U);
  if (!writeAll(file, writeScene(scene, teaching)) || ::fsync(file.get()) != 0 || !file.close() ||
      std::rename(part.c_str(), target.c_str()) != 0) {
    const Problems problems = problem(
        path,
        said(TRANSLATE_NOOP("problem", "The scene cannot be saved, what was there is untouched: %1."), {reason()}));
    ::unlink(part.c_str());
    return problems;
  }
  const std::filesystem::path folder = std::filesystem::path(target).parent_path();
  const Descriptor directory(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.get() >= 0) (void)::fsync(directory.get());  // so that the new name outlives a power cut, too
  return {};
}

}  // namespace underact::scene
