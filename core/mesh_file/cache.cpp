#include "core/mesh_file/cache.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/mesh_file/digest.h"
#include "core/mesh_file/limits.h"
#include "core/system/named_file.h"
#include "core/system/this_process.h"

namespace underact::mesh_file {
namespace {

namespace fs = std::filesystem;
using FileClock = fs::file_time_type::clock;

constexpr std::array<char, 8> kCacheMagic{'\x89', 'U', 'A', 'M', 'C', '1', '\r', '\n'};
constexpr const char* kExtension = ".mesh";
constexpr const char* kAside = ".part";
constexpr auto kAsideLives = std::chrono::hours(1);  // of a file whose writer was killed

struct CacheHead {
  std::array<char, 8> magic = kCacheMagic;
  std::uint64_t bytes = 0;
  std::array<char, 32> digest{};  // of the key and what follows
};

fs::path defaultFolder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  if (!variable("UNDERACT_CACHE_DIR").empty()) return variable("UNDERACT_CACHE_DIR");
  const std::string caches = variable("XDG_CACHE_HOME");
  // A relative path must not be used, by the specification.
  if (caches.starts_with('/')) return fs::path(caches) / "underact/meshes";
  const std::string home = variable("HOME");
  return home.empty() ? fs::path() : fs::path(home) / ".cache/underact/meshes";
}

/// Whether a key can be the name of a file.
bool isName(const std::string& key) {
  return !key.empty() && key.size() <= 128 && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

class Writing {
 public:
  Writing(const fs::path& path, const TaskMonitor& monitor) : file_(path, std::ios::binary), watch_(monitor) {}
  bool add(std::span<const std::byte> bytes) {
    while (!bytes.empty() && file_ && !watch_.isCancelled()) {
      const std::span<const std::byte> block = bytes.first(std::min(bytes.size(), kBlock));
      file_.write(reinterpret_cast<const char*>(block.data()), static_cast<std::streamsize>(block.size()));
      bytes = bytes.subspan(block.size());
    }
    return bytes.empty() && file_;
  }
  bool close() {
    file_.close();
    return !file_.fail();
  }

 private:
  std::ofstream file_;
  const TaskMonitor& watch_;
};

/// Whether the file has that many more bytes.
bool fills(const system::NamedFile& file, std::span<std::byte> into) {
  const Result<std::size_t> count = file.read({reinterpret_cast<char*>(into.data()), into.size()});
  return count && count.value() == into.size();
}

bool digestAll(Digest& digest, std::span<const std::byte> bytes, const TaskMonitor& monitor) {
  for (; !bytes.empty() && !monitor.isCancelled(); bytes = bytes.subspan(std::min(bytes.size(), kBlock))) {
    digest.add(bytes.first(std::min(bytes.size(), kBlock)));
  }
  return bytes.empty();
}

}  // namespace

Cache::Cache(std::string folder, std::uint64_t max_bytes)
    : folder_(folder.empty() ? defaultFolder().string() : std::move(folder)), max_bytes_(max_bytes) {}

std::optional<std::vector<std::byte>> Cache::get(const std::string& key, const TaskMonitor& monitor) const {
  if (folder_.empty() || !isName(key)) return {};
  const fs::path path = fs::path(folder_) / (key + kExtension);
  const Result<system::NamedFile> file = system::NamedFile::open(path.string(), "a kept mesh");
  CacheHead head;
  if (!file || !fills(file.value(), std::as_writable_bytes(std::span(&head, 1)))) return {};
  // The stated length is accepted if the file has it.
  if (head.magic != kCacheMagic || file.value().bytes() != sizeof head + head.bytes) return {};
  std::vector<std::byte> bytes(head.bytes);
  for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
    if (monitor.isCancelled()) return {};
    if (!fills(file.value(), std::span(bytes).subspan(at, std::min(kBlock, bytes.size() - at)))) return {};
  }
  Digest digest;
  digest.add(std::as_bytes(std::span(key)));
  if (!digestAll(digest, bytes, monitor)) return {};
  if (digest.text() != std::string_view(head.digest.data(), head.digest.size())) return {};
  std::error_code error;
  fs::last_write_time(path, FileClock::now(), error);  // used last, now
  return bytes;
}

bool Cache::put(const std::string& key, std::span<const std::span<const std::byte>> parts,
                const TaskMonitor& monitor) const {
  if (folder_.empty() || !isName(key)) return false;
  CacheHead head;
  Digest digest;
  digest.add(std::as_bytes(std::span(key)));
  for (const std::span<const std::byte> part : parts) {
    head.bytes += part.size();
    if (!digestAll(digest, part, monitor)) return false;
  }
  if (head.bytes + sizeof head > max_bytes_) return false;
  const std::string text = digest.text();
  std::copy(text.begin(), text.end(), head.digest.begin());
  std::error_code error;
  fs::create_directories(folder_, error);
  const fs::path aside = fs::path(folder_) / (key + "." + system::uniqueWord() + kAside);
  Writing writing(aside, monitor);
  bool is_ok = writing.add(std::as_bytes(std::span(&head, 1)));
  for (const std::span<const std::byte> part : parts) is_ok = is_ok && writing.add(part);
  is_ok = writing.close() && is_ok;
  if (is_ok) fs::rename(aside, fs::path(folder_) / (key + kExtension), error);
  if (!is_ok || error) {
    fs::remove(aside, error);
    return false;
  }
  makeRoom();
  return true;
}

void Cache::makeRoom() const {
  struct Entry {
    fs::path path;
    fs::file_time_type used;
    std::uint64_t bytes;
  };
  std::vector<Entry> entries;
  std::uint64_t sum = 0;
  std::error_code error;
  for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;  // removed by another program meanwhile
    const Entry entry{at->path(), at->last_write_time(gone), gone ? 0 : at->file_size(gone)};
    if (gone) continue;
    if (entry.path.extension() == kAside && FileClock::now() - entry.used > kAsideLives) fs::remove(entry.path, gone);
    if (entry.path.extension() != kExtension) continue;  // not of this program
    sum += entry.bytes;
    entries.push_back(entry);
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.used != b.used ? a.used < b.used : a.path < b.path; });
  for (const Entry& entry : entries) {
    if (sum <= max_bytes_) break;
    fs::remove(entry.path, error);
    sum -= entry.bytes;
  }
}

}  // namespace underact::mesh_file
