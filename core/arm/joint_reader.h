#pragma once
#include "core/arm/model.h"
#include "core/json/object_reader.h"

namespace underact::arm {

// Inside the room: the joints of an arm file, in each of its forms.

/// The rows of "dh" (in the convention of "convention") or the "joints" of a product of exponentials, with the poses
/// that belong to them, into the model: chain, rows, X_WB, X_NT, joints and masses. Problems go to the reader's
/// findings; where there are any, the model is not whole.
void readJoints(json::ObjectReader& object, Model& model);

/// The model with its table from its chain: for forms that give none.
void setTable(Model& model);

}  // namespace underact::arm
