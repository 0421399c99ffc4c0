#include "core/json/text_file.h"

#include "core/system/named_file.h"

namespace underact::json {

Result<std::string> readTextFile(const std::string& path, const Sentence& what, std::size_t largest) {
  const Result<system::NamedFile> file = system::NamedFile::open(path, what);
  return file ? file.value().readAll(largest) : file.problems();
}

}  // namespace underact::json
