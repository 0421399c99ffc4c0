#pragma once
#include <pybind11/pybind11.h>

#include <string>

namespace underact::bindings {

/// Takes an object of one of our classes from Python. One that __new__ gave and no __init__ filled, as by a crafted
/// pickle, is a TypeError: pybind11 takes it for memory that is about to be filled, so the call would read what is not
/// there.
template <class T>
struct MadeCaster : pybind11::detail::type_caster_base<T> {
  bool load(pybind11::handle given, bool convert) {
    namespace detail = pybind11::detail;
    if (given && this->typeinfo != nullptr && PyObject_TypeCheck(given.ptr(), this->typeinfo->type)) {
      for (const detail::value_and_holder& held :
           detail::values_and_holders(reinterpret_cast<detail::instance*>(given.ptr()))) {
        if (!held.holder_constructed())
          throw pybind11::type_error(std::string("This ") + this->typeinfo->type->tp_name +
                                     " has no content: its __init__ was not called.");
      }
    }
    return detail::type_caster_base<T>::load(given, convert);
  }
};

/// Gives each class another size than all others: so Python refuses to make an object of one an object of another by
/// its __class__, whose content it has not.
pybind11::custom_type_setup ownSize();

/// A class of the module whose objects can be neither copied nor pickled, with a TypeError, where a class of Python
/// that has it inside has no way of its own.
template <class T>
pybind11::class_<T> madeClass(pybind11::module_& core, const char* name) {
  pybind11::class_<T> made(core, name, ownSize());
  made.def("__reduce__", [](const pybind11::object& self) -> pybind11::object {
    throw pybind11::type_error(std::string("A ") + Py_TYPE(self.ptr())->tp_name +
                               " cannot be copied or pickled; what it was made from can.");
  });
  return made;
}

/// Makes the base of all our classes refuse to be made itself, with a TypeError: pybind11 ends the interpreter. Called
/// before any class is made. The base is this module's alone, by PYBIND11_COMPILER_TYPE in CMakeLists.txt.
void refuseBase();

}  // namespace underact::bindings
