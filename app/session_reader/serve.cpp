#include "app/session_reader/serve.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "core/base/translate.h"
#include "core/helper/connection.h"
#include "core/helper/sentence_codec.h"
#include "core/record/hdf5_file.h"
#include "core/record/reader_protocol.h"
#include "core/record/session_tables.h"
#include "core/system/sandbox.h"
#include "core/system/this_process.h"

namespace underact::session_reader {
namespace {

using record::Block;
using record::Hdf5File;
using record::Question;
using record::QuestionKind;

// A program that renders a surface meanwhile needs the processor more.
constexpr int kNice = 5;
// The longest possible block takes 80 MB, several times over.
constexpr std::uint64_t kMaxMemory = std::uint64_t{384} << 20;
constexpr double kMaxCpu_s = 3600.0;  // of all answers; the program that asks watches each

using Bytes = std::span<const std::byte>;

template <class Number>
Bytes bytesOf(const Number& number) {
  return std::as_bytes(std::span(&number, 1));
}

bool sayYes(std::initializer_list<Bytes> parts) {
  std::vector<Bytes> all{bytesOf(record::kYes)};
  all.insert(all.end(), parts);
  return helper::answer(all);
}

bool sayNo(const Problems& problems) {
  const std::string letters = problems.empty() ? std::string() : helper::encodeSentence(problems.front().sentence);
  const std::array parts{bytesOf(record::kNo), std::as_bytes(std::span(letters))};
  return helper::answer(parts);
}

bool sayShape(Hdf5File& file) {
  record::Shape shape;
  for (std::size_t table = 0; table < record::kTables; ++table) {
    shape.rows[table] = file.rows(table);
    shape.block_rows[table] = file.blockRows(table);
  }
  shape.is_open_elsewhere = file.isOpenElsewhere() ? 1 : 0;
  return sayYes({bytesOf(shape)});
}

bool sayBlocks(const std::vector<Block>& blocks) {
  std::vector<std::byte> whole;
  for (const Block& block : blocks) whole.push_back(block.bytes.empty() ? record::kNo : record::kYes);
  std::vector<Bytes> parts{bytesOf(record::kYes), whole};
  for (const Block& block : blocks) parts.emplace_back(block.bytes);
  return helper::answer(parts);
}

/// The session, and the program that asks about it.
class Service {
 public:
  /// false: nobody reads the answer.
  bool answer(const Question& question) {
    if (question.what == QuestionKind::Open) return open(question);
    return file_ ? answer(*file_, question) : sayNo({});
  }

 private:
  bool open(const Question& question) {
    const std::array tables = record::sessionTables(1000);  // the file states how many rows a block of ticks has
    Result<Hdf5File> file = Hdf5File::openAt(helper::kFile, tables, question.at_least);
    if (!file) return sayNo(file.problems());
    file_ = std::move(file).value();
    return sayShape(*file_);
  }
  static bool answer(Hdf5File& file, const Question& question) {
    const std::string name(question.name.data(), strnlen(question.name.data(), question.name.size()));
    switch (question.what) {
      case QuestionKind::Open:
        break;
      case QuestionKind::Refresh:
        file.refresh();
        return sayShape(file);
      case QuestionKind::Read: {
        if (question.table >= record::kTables) return sayNo({});
        const Result<std::vector<Block>> blocks = file.read(question.table, question.first, question.count);
        return blocks ? sayBlocks(blocks.value()) : sayNo(blocks.problems());
      }
      case QuestionKind::Text: {
        const std::string text = file.text(name);
        return sayYes({std::as_bytes(std::span(text))});
      }
      case QuestionKind::Integer: {
        const std::int64_t number = file.integer(name, question.fallback);
        return sayYes({bytesOf(number)});
      }
      case QuestionKind::Real: {
        const double number = file.real(name, question.real_fallback);
        return sayYes({bytesOf(number)});
      }
    }
    return sayNo({});
  }
  std::optional<Hdf5File> file_;
};

}  // namespace

int serve() {
  system::lowerPriority(kNice);
  if (!record::startHdf5() || !system::enterSandbox(kMaxMemory, kMaxCpu_s)) return helper::kNotSealed;
  Service service;
  Question question;
  while (helper::nextQuestion(std::as_writable_bytes(std::span(&question, 1)))) {
    try {
      if (!service.answer(question)) return 1;
    } catch (const std::bad_alloc&) {
      const bool is_heard = sayNo({{phrase(
          TRANSLATE_NOOP("problem", "The file is damaged, or takes more memory than a file of its size should."))}});
      if (!is_heard) return 1;
    }
  }
  return 0;
}

}  // namespace underact::session_reader
