#include "core/mesh_file/off_header.h"

#include <array>
#include <string>

#include "core/base/translate.h"
#include "core/mesh_file/scan.h"

namespace underact::mesh_file {

bool isOffKeyword(std::string_view word) {
  if (!word.ends_with("OFF")) return false;
  word.remove_suffix(3);
  for (const std::string_view letter : {"ST", "C", "N", "4", "n"}) {
    if (word.starts_with(letter)) word.remove_prefix(letter.size());
  }
  return word.empty();
}

Result<OffHeader> readOffHeader(std::string_view head) {
  Scan lines(head);
  std::string words;  // of the lines so far, without remarks
  while (!lines.atEnd()) {
    const std::string_view line = lines.line();
    words.append(line.substr(0, line.find('#'))).append(" ");
    Scan scan(words);
    const std::string_view keyword = scan.word();
    if (keyword.empty()) {
      words.clear();  // else every line would be looked at again for each that follows
      continue;
    }
    if (!isOffKeyword(keyword))
      return Problems{
          {phrase(TRANSLATE_NOOP("problem", "The OFF header is damaged: it does not begin with \"OFF\".")), {}}};
    if (keyword.find('4') != std::string_view::npos || keyword.find('n') != std::string_view::npos) {
      return Problems{{phrase(TRANSLATE_NOOP("problem", "The mesh in the OFF file is not three-dimensional.")), {}}};
    }
    std::array<std::string_view, 3> counts{scan.word(), scan.word(), scan.word()};
    if (counts[0] == "BINARY") {
      return Problems{
          {phrase(TRANSLATE_NOOP(
               "problem", "This is a binary OFF file, which cannot be read. Save it as text, or as STL or PLY.")),
           {}}};
    }
    // The third number, of edges, is not used, and some programs leave it out.
    if (counts[1].empty()) {
      if (words.size() > 4096) break;
      continue;
    }
    OffHeader header;
    if (!readInteger(counts[0], header.corners) || !readInteger(counts[1], header.faces)) break;
    if (header.faces == 0)
      return Problems{
          {phrase(TRANSLATE_NOOP("problem", "The OFF file contains points but no faces. A surface needs faces.")), {}}};
    header.bytes = lines.place();
    header.lines = lines.lineNumber();
    return header;
  }
  return Problems{{phrase(TRANSLATE_NOOP(
                       "problem", "The OFF header is damaged: the numbers of vertices and faces cannot be read.")),
                   {}}};
}

}  // namespace underact::mesh_file
