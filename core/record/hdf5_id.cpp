#include "core/record/hdf5_id.h"

#include <hdf5.h>

#include <algorithm>
#include <type_traits>

#include "core/record/session_tables.h"

namespace underact::record {

static_assert(std::is_same_v<Handle, hid_t>);

namespace {

// What is left of a file that could not be closed, on a full disk, makes the library's work at the exit crash. All
// files are closed before, and what the library has in memory beyond them is lost either way.
void leaveTheExitAlone() {
  static const herr_t once = H5dont_atexit();
  (void)once;
}

}  // namespace

bool startHdf5() {
  leaveTheExitAlone();
  return H5open() >= 0 && H5PLset_loading_state(0) >= 0;
}

void quiet() {
  leaveTheExitAlone();
  thread_local const herr_t once = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  (void)once;
}

namespace {

constexpr auto kLongestText = static_cast<std::size_t>(kSessionLimits.attribute_bytes);

bool writeText(hid_t object, const std::string& name, const std::string& text) {
  const Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(text.size(), 1));
  H5Tset_cset(type, H5T_CSET_UTF8);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const Id space(H5Screate(H5S_SCALAR), H5Sclose);
  const Id attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  std::string padded = text;
  padded.resize(std::max<std::size_t>(text.size(), 1));
  return attribute.isGood() && H5Awrite(attribute, type, padded.data()) >= 0;
}

template <class Number>
bool writeNumber(hid_t object, const std::string& name, hid_t type, hid_t memory, Number number) {
  const Id space(H5Screate(H5S_SCALAR), H5Sclose);
  const Id attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.isGood() && H5Awrite(attribute, memory, &number) >= 0;
}

std::optional<Id> scalarAttribute(hid_t object, std::string_view name, H5T_class_t wanted) {
  Id attribute(H5Aopen(object, std::string(name).c_str(), H5P_DEFAULT), H5Aclose);
  if (!attribute.isGood()) return {};
  const Id type(H5Aget_type(attribute), H5Tclose);
  const Id space(H5Aget_space(attribute), H5Sclose);
  if (H5Tget_class(type) != wanted || H5Sget_simple_extent_npoints(space) != 1) return {};
  return attribute;
}

template <class Number>
std::optional<Number> numberOf(hid_t object, std::string_view name, H5T_class_t wanted, hid_t memory) {
  const std::optional<Id> attribute = scalarAttribute(object, name, wanted);
  Number number{};
  if (!attribute || H5Aread(*attribute, memory, &number) < 0) return {};
  return number;
}

}  // namespace

bool isOwn(Handle group, std::string_view name) {
  H5L_info_t link{};
  return H5Lget_info(group, std::string(name).c_str(), &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD;
}

bool writeAttribute(Handle object, const Attribute& attribute) {
  if (const auto* text = std::get_if<std::string>(&attribute.value)) return writeText(object, attribute.name, *text);
  if (const auto* integer = std::get_if<std::int64_t>(&attribute.value))
    return writeNumber(object, attribute.name, H5T_STD_I64LE, H5T_NATIVE_INT64, *integer);
  return writeNumber(object, attribute.name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, std::get<double>(attribute.value));
}

std::optional<std::string> textAttribute(Handle object, std::string_view name) {
  const std::optional<Id> open = scalarAttribute(object, name, H5T_STRING);
  if (!open) return {};
  const Id type(H5Aget_type(*open), H5Tclose);
  const std::size_t size = H5Tget_size(type);
  if (H5Tis_variable_str(type) != 0 || size > kLongestText) return {};
  std::string text(size, '\0');
  if (H5Aread(*open, type, text.data()) < 0) return {};
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

std::optional<std::int64_t> integerAttribute(Handle object, std::string_view name) {
  return numberOf<std::int64_t>(object, name, H5T_INTEGER, H5T_NATIVE_INT64);
}

std::optional<double> realAttribute(Handle object, std::string_view name) {
  return numberOf<double>(object, name, H5T_FLOAT, H5T_NATIVE_DOUBLE);
}

}  // namespace underact::record
