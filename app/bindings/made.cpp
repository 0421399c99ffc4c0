#include "app/bindings/made.h"

namespace underact::bindings {
namespace {

extern "C" PyObject* underactMakeInstance(PyTypeObject* type, PyObject* /*positional*/, PyObject* /*named*/) {
  if (!pybind11::detail::all_type_info(type).empty()) return pybind11::detail::make_new_instance(type);
  PyErr_Format(PyExc_TypeError, "A %.200s cannot be made: it has no content.", type->tp_name);
  return nullptr;
}

}  // namespace

pybind11::custom_type_setup ownSize() {
  static Py_ssize_t classes = 0;  // guarded by the interpreter's lock
  return pybind11::custom_type_setup([number = ++classes](PyHeapTypeObject* type) {
    type->ht_type.tp_basicsize += number * static_cast<Py_ssize_t>(sizeof(void*));
  });
}

void refuseBase() {
  auto* const base = reinterpret_cast<PyTypeObject*>(pybind11::detail::get_internals().instance_base);
  base->tp_new = &underactMakeInstance;
  PyType_Modified(base);
}

}  // namespace underact::bindings
