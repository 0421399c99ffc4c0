#pragma once
#include <string>

#include "core/base/types.h"
#include "core/json/object_reader.h"

namespace underact::arm {

// Inside the room: values of an arm file, each with its problems.

/// A finite number; otherwise where the key is absent.
double numberAt(json::ObjectReader& object, const char* key, bool required, double otherwise = 0.0);
/// A length of at most 1 km, m, from mm.
double lengthAt(json::ObjectReader& object, const char* key, bool required = true);
/// Three lengths, m, from mm.
Vec3 pointAt(json::ObjectReader& object, const char* key, bool required);
/// true or false.
bool flagAt(json::ObjectReader& object, const char* key, bool otherwise);
/// Four rows of four, the last 0, 0, 0, 1, lengths mm; X as it was where the key is absent. notes: gets that of a
/// rotation of few decimals.
void readPose(json::ObjectReader& object, const char* key, bool required, Pose& X, Problems* notes = nullptr);
/// A pose as text.
std::string poseText(const Pose& X);

}  // namespace underact::arm
