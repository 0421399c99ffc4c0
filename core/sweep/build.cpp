#include "core/sweep/build.h"

#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

#include "core/json/text_file.h"
#include "core/sweep/checksum.h"

namespace underact::sweep {
namespace {

constexpr std::size_t kLargestProgram = std::size_t{4} << 30U;

/// The content of the note with which the linker told builds apart; empty: there is none.
std::string_view buildIdIn(const char* notes, std::size_t size, std::size_t align) {
  const auto padded = [align](std::size_t bytes) { return (bytes + align - 1) / align * align; };
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes, sizeof note);
    const std::size_t name_at = sizeof note, id_at = padded(name_at + note.n_namesz);
    const std::size_t next = padded(id_at + note.n_descsz);
    if (id_at + note.n_descsz > size) return {};
    const std::string_view name(notes + name_at, note.n_namesz);
    if (note.n_type == NT_GNU_BUILD_ID && name == std::string_view("GNU\0", 4)) return {notes + id_at, note.n_descsz};
    if (next >= size) return {};
    notes += next;
    size -= next;
  }
  return {};
}

std::string_view buildIdOf(const dl_phdr_info& object) {
  for (ElfW(Half) i = 0; i < object.dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = object.dlpi_phdr[i];
    if (part.p_type != PT_NOTE) continue;
    const auto* const notes = reinterpret_cast<const char*>(object.dlpi_addr + part.p_vaddr);
    const std::string_view id = buildIdIn(notes, part.p_memsz, std::max<std::size_t>(part.p_align, 4));
    if (!id.empty()) return id;
  }
  return {};
}

/// Whether an object in memory decides what numbers come out: the program, first and without a name, and the libraries
/// of trigonometry and of powers. Others (MPI's parts, what the kernel puts in) may differ from rank to rank.
bool computes(std::string_view path, bool is_program) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  return is_program || name.starts_with("libsleef.") || name.starts_with("libm.");
}

int note(dl_phdr_info* object, std::size_t /*size*/, void* list) {
  auto& found = *static_cast<std::vector<std::string>*>(list);
  const bool is_program = found.empty();
  if (!computes(object->dlpi_name, is_program)) return 0;
  const std::string_view id = buildIdOf(*object);
  if (!id.empty()) {
    found.emplace_back(id);
    return 0;
  }
  const std::string path = is_program ? "/proc/self/exe" : object->dlpi_name;
  const Result<std::string> bytes = json::readTextFile(path, "a program", kLargestProgram);
  found.push_back(bytes ? checksumOf(bytes.value()) : "unknown");
  return 0;
}

}  // namespace

const std::string& buildOf() {
  static const std::string kBuild = [] {
    std::vector<std::string> found;
    dl_iterate_phdr(note, &found);
    std::sort(found.begin(), found.end());  // libraries come in the order in which they were loaded
    std::string all;
    for (const std::string& one : found) all += one + "\n";
    return checksumOf(all);
  }();
  return kBuild;
}

}  // namespace underact::sweep
