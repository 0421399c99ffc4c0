#include "core/record/csv.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include "core/base/units.h"

namespace underact::record {
namespace {

constexpr double kMicrosecondPerNanosecond = 1e-3;

constexpr std::string_view kHeader =
    "tick,time_s,q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad,x_mm,y_mm,z_mm,target_x_mm,target_y_mm,target_z_mm,error_mm,"
    "force_asked_x_N,force_asked_y_N,force_asked_z_N,force_sent_x_N,force_sent_y_N,force_sent_z_N,gate_level,cut_N,"
    "fault,alpha_rad,beta_rad,theta_rad,lateness_us,tick_us,buttons,revision\n";

/// One line, in place. 31 fields of at most 25 characters each fit.
class Row {
 public:
  template <class Integer>
  void integer(Integer value) {
    end_ = std::to_chars(end_, text_.data() + text_.size(), value).ptr;
    separate();
  }
  /// An empty field where it is no number: every reader of tables takes it for "not there".
  void number(double value) {
    if (std::isfinite(value)) end_ = std::to_chars(end_, text_.data() + text_.size(), value).ptr;
    separate();
  }
  void vector(const Vec3& value) {
    for (const double coordinate : value) number(coordinate);
  }
  void word(std::string_view value) {
    end_ = std::copy(value.begin(), value.end(), end_);
    separate();
  }
  std::string_view finished() {
    end_[-1] = '\n';
    return {text_.data(), static_cast<std::size_t>(end_ - text_.data())};
  }

 private:
  void separate() { *end_++ = ','; }
  std::array<char, 1024> text_{};
  char* end_ = text_.data();
};

}  // namespace

Result<CsvWriter> CsvWriter::open(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "wbe");
  if (file == nullptr) {
    return Problems{{std::string("The recording cannot be made: ") + std::strerror(errno) + ".", {path}}};
  }
  CsvWriter writer(file, path);
  writer.write(kHeader);
  return writer;
}

void CsvWriter::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) error_ = errno;
}

void CsvWriter::add(const servo::TickRecord& record) {
  if (error_ != 0) return;
  Row row;
  row.integer(record.tick);
  row.number(kSecondPerNanosecond * static_cast<double>(record.time_ns));
  for (const double angle_rad : record.q_rad) row.number(angle_rad);
  row.vector(kMillimetrePerMetre * record.p_WT);
  row.vector(kMillimetrePerMetre * record.p_WP);
  row.number(kMillimetrePerMetre * record.error_m);
  row.vector(record.f_asked_T_W);
  row.vector(record.f_sent_T_W);
  row.number(record.level);
  row.number(record.cut_N);
  row.word(name(record.fault));
  row.number(record.angles.alpha_rad);
  row.number(record.angles.beta_rad);
  row.number(record.angles.theta_rad);
  row.number(kMicrosecondPerNanosecond * static_cast<double>(record.lateness_ns));
  row.number(kMicrosecondPerNanosecond * static_cast<double>(record.tick_ns));
  row.integer(record.buttons);
  row.integer(record.revision);
  write(row.finished());
}

Problems CsvWriter::close() {
  if (file_ == nullptr) return {};
  if (std::fflush(file_.get()) != 0 && error_ == 0) error_ = errno;
  if (std::fclose(file_.release()) != 0 && error_ == 0) error_ = errno;
  if (error_ == 0) return {};
  return {{std::string("The recording is not whole: ") + std::strerror(error_) + ".", {path_}}};
}

}  // namespace underact::record
