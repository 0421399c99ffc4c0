#ifdef __linux__
#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "core/system/library.h"

namespace underact::system {
namespace {

/// The linker's build id in the notes; empty: none.
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

int note(dl_phdr_info* object, std::size_t /*size*/, void* list) {
  auto& found = *static_cast<std::vector<Loaded>*>(list);
  found.push_back({found.empty() ? "/proc/self/exe" : object->dlpi_name, std::string(buildIdOf(*object))});
  return 0;
}

}  // namespace

std::vector<Loaded> loadedHere() {
  std::vector<Loaded> found;
  ::dl_iterate_phdr(note, &found);
  return found;
}

}  // namespace underact::system
#endif
