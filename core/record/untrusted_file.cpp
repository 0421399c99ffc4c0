#include "core/record/untrusted_file.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include "core/base/translate.h"
#include "core/helper/connection.h"
#include "core/helper/sentence_codec.h"
#include "core/record/reader_protocol.h"
#include "core/record/session_tables.h"
#include "core/system/resource_paths.h"

namespace underact::record {
namespace {

constexpr const char* kSessionReader = "underact-session-reader";
constexpr auto kLongestAttribute = static_cast<std::size_t>(kSessionLimits.attribute_bytes) + 1;

/// A question about an attribute; an empty name is of no attribute.
Question questionOf(QuestionKind what, std::string_view name) {
  Question question;
  question.what = what;
  if (name.size() < question.name.size()) std::copy(name.begin(), name.end(), question.name.begin());
  return question;
}

template <class Number>
std::optional<Number> numberIn(std::span<const std::byte> bytes) {
  Number number{};
  if (bytes.size() != sizeof number) return {};
  std::memcpy(&number, bytes.data(), sizeof number);
  return number;
}

/// Whether an answer is plausible: a helper is trusted as little as the file that it reads.
bool fits(const Shape& shape, std::span<const Table> tables, std::int64_t bytes) {
  for (std::size_t index = 0; index < tables.size(); ++index) {
    const Table& table = tables[index];
    const std::int64_t rows = shape.rows[index], block_rows = shape.block_rows[index];
    const bool is_block = table.max_block_rows == 0 ? block_rows == table.block_rows
                                                    : block_rows >= 1 && block_rows <= table.max_block_rows;
    const std::int64_t max = std::min(bytes, kLongestFile) / static_cast<std::int64_t>(rowBytes(table));
    if (!is_block || rows < 0 || rows > kMaxPacked * max + block_rows) return false;
  }
  return shape.is_open_elsewhere == 0 || shape.is_open_elsewhere == 1;
}

}  // namespace

struct UntrustedFile::Impl {
  std::shared_ptr<const UntrustedInput> input;
  std::vector<Table> tables;
  std::int64_t at_least = 0;
  helper::HelperConnection talk;
  Shape shape;

  Problems problem(Sentence sentence) const { return {{std::move(sentence), {input->path()}}}; }
  Problems unreadable() const {
    return problem(phrase(TRANSLATE_NOOP("problem", "The file is damaged, and the rest cannot be read.")));
  }
  /// The reason why there was no answer.
  Problems silenceReason(const helper::Bounds& bounds) const {
    using helper::Ending;
    switch (talk.ending()) {
      case Ending::Crashed:
        return problem(phrase(TRANSLATE_NOOP("problem", "The file is damaged: the reader program crashed (signal %1)."),
                              {std::to_string(talk.code())}));
      case Ending::TookTooLong:
        return problem(phrase(TRANSLATE_NOOP("problem",
                                             "The file is damaged: reading a part of it took longer than %1, which "
                                             "is enough for any session."),
                              {helper::secondsText(bounds.max_cpu_s)}));
      case Ending::Waited:
        return problem(helper::timeoutText(bounds.max_time_s));
      case Ending::NotStarted:
      case Ending::NotSandboxed:
        return problem(helper::helperFailureText(talk.ending(), kSessionReader, talk.code()));
      default:
        return unreadable();
    }
  }
  /// The answer after a yes. Problems: the sentence after a no, and why there was no answer.
  Result<std::vector<std::byte>> ask(const Question& question, std::size_t max_bytes) {
    helper::Bounds bounds;
    bounds.max_bytes = std::max(max_bytes, helper::kMaxLetters) + 1;
    std::optional<std::vector<std::byte>> answer = talk.ask(std::as_bytes(std::span(&question, 1)), bounds);
    if (!answer) return silenceReason(bounds);
    if (answer->empty()) return unreadable();
    const std::byte yes = answer->front();
    answer->erase(answer->begin());
    if (yes == kYes) return std::move(*answer);
    const std::optional<Sentence> why =
        helper::decodeSentence({reinterpret_cast<const char*>(answer->data()), answer->size()});
    return why && !why->empty() ? problem(*why) : unreadable();
  }
  Problems request(QuestionKind what) {
    Question question;
    question.what = what;
    question.at_least = at_least;
    const Result<std::vector<std::byte>> answer = ask(question, sizeof(Shape));
    if (!answer) return answer.problems();
    const std::optional<Shape> now = numberIn<Shape>(answer.value());
    if (!now || !fits(*now, tables, std::max(input->bytes(), at_least))) return unreadable();
    shape = *now;
    return {};
  }
};

UntrustedFile::UntrustedFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
UntrustedFile::UntrustedFile(UntrustedFile&&) noexcept = default;
UntrustedFile& UntrustedFile::operator=(UntrustedFile&&) noexcept = default;
UntrustedFile::~UntrustedFile() = default;

Result<UntrustedFile> UntrustedFile::open(std::shared_ptr<const UntrustedInput> input, std::span<const Table> tables,
                                          std::int64_t at_least) {
  auto impl = std::make_unique<Impl>();
  impl->input = std::move(input);
  impl->tables.assign(tables.begin(), tables.end());
  impl->at_least = at_least;
  const Result<std::string> program = system::findProgram(kSessionReader, "UNDERACT_SESSION_READER");
  if (!program)
    return impl->problem(
        oneAfterAnother({program.problems().front().sentence,
                         phrase(TRANSLATE_NOOP("problem", "It reads sessions: reinstall Underact."))}));
  impl->talk = helper::HelperConnection(program.value(), impl->input->fd());
  const Problems problems = impl->request(QuestionKind::Open);
  if (!problems.empty()) return problems;
  UntrustedFile file(std::move(impl));
  if (file.isOpenElsewhere()) file.impl_->input->unlock();  // its writer may continue
  return file;
}

std::int64_t UntrustedFile::rows(std::size_t table) const {
  return impl_->shape.rows[table];
}

std::int64_t UntrustedFile::blockRows(std::size_t table) const {
  return impl_->shape.block_rows[table];
}

Result<std::vector<Block>> UntrustedFile::read(std::size_t table, std::int64_t first, std::int64_t count) {
  const std::int64_t block_rows = blockRows(table);
  const RowRange wanted = rangeOf(first, count, block_rows, rows(table));
  const auto blocks = static_cast<std::size_t>(wanted.blocks(block_rows));
  if (blocks == 0) return std::vector<Block>{};
  const std::size_t row_bytes = rowBytes(impl_->tables[table]);
  Question question;
  question.what = QuestionKind::Read;
  question.table = table;
  question.first = first;
  question.count = count;
  const Result<std::vector<std::byte>> answer =
      impl_->ask(question, blocks + static_cast<std::size_t>(wanted.end - wanted.begin) * row_bytes);
  if (!answer) return answer.problems();
  std::span<const std::byte> bytes = answer.value();
  if (bytes.size() < blocks) return impl_->unreadable();
  const std::span<const std::byte> whole = bytes.first(blocks);
  bytes = bytes.subspan(blocks);
  std::vector<Block> read(blocks);
  for (std::size_t index = 0; index < blocks; ++index) {
    Block& block = read[index];
    block.rows = std::min(block_rows, wanted.end - wanted.begin - static_cast<std::int64_t>(index) * block_rows);
    if (whole[index] != kYes) continue;
    const std::size_t size = static_cast<std::size_t>(block.rows) * row_bytes;
    if (bytes.size() < size) return impl_->unreadable();
    block.bytes.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    bytes = bytes.subspan(size);
  }
  if (!bytes.empty()) return impl_->unreadable();
  return read;
}

void UntrustedFile::refresh() {
  (void)impl_->request(QuestionKind::Refresh);  // on failure the old state stays, and reading it reports why
}

std::string UntrustedFile::text(std::string_view attribute) {
  const Result<std::vector<std::byte>> answer =
      impl_->ask(questionOf(QuestionKind::Text, attribute), kLongestAttribute);
  if (!answer) return {};
  return {reinterpret_cast<const char*>(answer.value().data()), answer.value().size()};
}

std::int64_t UntrustedFile::integer(std::string_view attribute, std::int64_t fallback) {
  Question question = questionOf(QuestionKind::Integer, attribute);
  question.fallback = fallback;
  const Result<std::vector<std::byte>> answer = impl_->ask(question, sizeof fallback);
  return answer ? numberIn<std::int64_t>(answer.value()).value_or(fallback) : fallback;
}

double UntrustedFile::real(std::string_view attribute, double fallback) {
  Question question = questionOf(QuestionKind::Real, attribute);
  question.real_fallback = fallback;
  const Result<std::vector<std::byte>> answer = impl_->ask(question, sizeof fallback);
  return answer ? numberIn<double>(answer.value()).value_or(fallback) : fallback;
}

bool UntrustedFile::isOpenElsewhere() const {
  return impl_->shape.is_open_elsewhere == 1;
}

}  // namespace underact::record
