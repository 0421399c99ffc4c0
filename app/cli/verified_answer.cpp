#include "app/cli/verified_answer.h"

#include <ostream>

#include "core/base/printed.h"

namespace underact::cli {

bool addDifference(JsonObject& answer, const record::Verified& verified, const Streams& streams) {
  if (!verified.unknown.empty()) streams.err << printed(verified.unknown) << '\n';
  if (!verified.differs) return verified.unknown.empty();
  answer.addInteger("first_difference_tick", verified.differs->tick);
  answer.addText("first_difference_column", verified.differs->column);
  streams.err << "Tick " << verified.differs->tick << " differs: " << verified.differs->column << ".\n";
  if (verified.mended.empty()) return false;
  answer.addTexts("mended_laws", verified.mended);
  answer.addInteger("different_ticks", verified.different_ticks);
  for (const std::string& law : verified.mended)
    streams.err << "The law of " << law << " was mended after this session was made; with what it computes now, "
                << verified.different_ticks << " ticks differ.\n";
  return false;
}

}  // namespace underact::cli
