#include "app/bindings/numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace underact::bindings {
namespace {

constexpr int kAligned = 0x0100;  // NPY_ARRAY_ALIGNED

using Doubles = py::array_t<double, py::array::c_style>;

std::string shapeText(std::span<const py::ssize_t> shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(shape[i]);
  return text + (shape.size() == 1 ? ",)" : ")");
}

std::string typeName(const py::handle& given) {
  return py::str(py::type::handle_of(given).attr("__name__"));
}

[[noreturn]] void raiseType(const char* name, const std::string& what) {
  throw py::type_error(std::string(name) + " must be numbers, as of a numpy array or nested lists, not " + what + ".");
}

/// Whether it is a masked array or a list with one: numpy would take the numbers under the mask for numbers.
bool isMasked(const py::handle& given, const py::handle& masked_array) {
  if (py::isinstance(given, masked_array)) return true;
  if (!py::isinstance<py::list>(given) && !py::isinstance<py::tuple>(given)) return false;
  return std::any_of(given.begin(), given.end(), [&](const py::handle& one) { return isMasked(one, masked_array); });
}

/// What numpy makes of anything but a plain array of doubles.
Doubles converted(const py::handle& given, const char* name) {
  if (given.is_none() || py::isinstance<py::str>(given) || py::isinstance<py::bytes>(given) ||
      py::isinstance<py::dict>(given) || py::isinstance<py::set>(given))
    raiseType(name, typeName(given));
  py::array array;
  try {
    array = py::module_::import("numpy").attr("asarray")(given);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    throw py::value_error(std::string(name) + " is no regular array: its rows must have the same length.");
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    raiseType(name, "values of type " + std::string(py::str(static_cast<py::object>(array.dtype()))));
  if (isMasked(given, py::module_::import("numpy.ma").attr("MaskedArray")))
    raiseType(name, "a masked array; pass what its filled() returns");
  return Doubles::ensure(array.attr("astype")("float64", py::arg("order") = "C"));
}

/// The place of an entry in an array, as an index is written in Python.
std::string placeOf(const Doubles& array, std::size_t flat) {
  std::vector<py::ssize_t> index(static_cast<std::size_t>(array.ndim()));
  for (std::size_t axis = index.size(); axis-- > 0;) {
    const auto length = static_cast<std::size_t>(array.shape(static_cast<py::ssize_t>(axis)));
    index[axis] = static_cast<py::ssize_t>(flat % length);
    flat /= length;
  }
  std::string text = "[";
  for (std::size_t i = 0; i < index.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(index[i]);
  return text + "]";
}

void checkNumbers(const Doubles& array, const char* name, double limit) {
  const auto numbers = std::span(array.data(), static_cast<std::size_t>(array.size()));
  const auto wrong = [limit](double number) { return !(std::abs(number) <= limit); };
  const auto found = std::find_if(numbers.begin(), numbers.end(), wrong);
  if (found == numbers.end()) return;
  const std::string number = py::str(py::float_(*found));
  const std::string largest = py::str(py::float_(limit));
  throw py::value_error(std::string(name) + placeOf(array, static_cast<std::size_t>(found - numbers.begin())) + " is " +
                        number + "; all numbers must be finite, of magnitude " + largest + " or less.");
}

}  // namespace

Rows readRows(const py::handle& given, const char* name, std::initializer_list<py::ssize_t> shape, double limit) {
  const bool is_plain = Py_TYPE(given.ptr()) == py::detail::npy_api::get().PyArray_Type_;
  const bool fits =
      is_plain && Doubles::check_(given) && (py::reinterpret_borrow<py::array>(given).flags() & kAligned) != 0;
  Rows rows{fits ? py::reinterpret_borrow<Doubles>(given) : converted(given, name), {}, 1, 1};
  const std::span<const py::ssize_t> all(rows.array.shape(), static_cast<std::size_t>(rows.array.ndim()));
  if (all.size() < shape.size() ||
      !std::equal(shape.begin(), shape.end(), all.end() - static_cast<std::ptrdiff_t>(shape.size()))) {
    std::string wanted = shapeText(std::vector<py::ssize_t>(shape));
    wanted = "(..., " + (shape.size() == 1 ? wanted.substr(1, wanted.size() - 3) + ")" : wanted.substr(1));
    throw py::value_error(std::string(name) + " must have the shape " + wanted + ", not " + shapeText(all) + ".");
  }
  rows.lead.assign(all.begin(), all.end() - static_cast<std::ptrdiff_t>(shape.size()));
  for (const py::ssize_t length : rows.lead) rows.count *= static_cast<std::size_t>(length);
  for (const py::ssize_t length : shape) rows.size *= static_cast<std::size_t>(length);
  checkNumbers(rows.array, name, limit);
  return rows;
}

py::array_t<double> emptyRows(const std::vector<py::ssize_t>& lead, std::initializer_list<py::ssize_t> row) {
  return emptyOf<double>(lead, row);
}

void raiseProblems(const Problems& problems) {
  std::string text;
  bool unread = false;
  for (const Problem& problem : problems) {
    const bool has_place = !problem.place.file.empty();
    text += (text.empty() ? "" : "\n") + (has_place ? describe(problem) : std::string(problem.sentence));
    unread = unread || (has_place && problem.place.line == 0);
  }
  if (unread) {
    PyErr_SetString(PyExc_OSError, text.c_str());
    throw py::error_already_set();
  }
  throw py::value_error(text);
}

}  // namespace underact::bindings
