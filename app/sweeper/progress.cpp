#include "app/sweeper/progress.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace underact::sweep {

std::string inWords(double seconds) {
  if (seconds < 1.0) return "less than a second";
  if (seconds < 100.0) return std::to_string(std::llround(seconds)) + " s";
  const long long minutes = std::llround(seconds / 60.0);
  if (minutes < 100) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

Progress::Progress(std::ostream& err, bool in_place, bool quiet, std::size_t done, std::size_t all)
    : err_(err),
      in_place_(in_place),
      quiet_(quiet),
      before_(done),
      all_(all),
      begin_(std::chrono::steady_clock::now()),
      shown_(begin_) {}

void Progress::show(std::size_t done, std::chrono::steady_clock::time_point now) {
  if (quiet_ || now - shown_ < std::chrono::seconds(in_place_ ? 1 : 10)) return;
  shown_ = now;
  std::string text =
      std::to_string(done) + " of " + std::to_string(all_) + " cells, " + std::to_string(100 * done / all_) + " %";
  if (done > before_) {
    const double each_s = std::chrono::duration<double>(now - begin_).count() / static_cast<double>(done - before_);
    text += ", about " + inWords(each_s * static_cast<double>(all_ - done)) + " left";
  }
  // On a terminal spaces cover what was longer before.
  if (in_place_) {
    text.resize(std::max<std::size_t>(text.size(), 70), ' ');
    err_ << '\r' << text << std::flush;
    on_line_ = true;
  } else {
    err_ << text << std::endl;
  }
}

void Progress::end() {
  if (on_line_) err_ << '\n';
  on_line_ = false;
}

}  // namespace underact::sweep
