#include "app/mesh_reader/prepare.h"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "app/mesh_reader/numbers.h"
#include "core/base/translate.h"
#include "core/mesh_file/off_header.h"
#include "core/mesh_file/stl_binary.h"

namespace underact::mesh_reader {
namespace {

using mesh_file::Scan;

// OpenMesh finds equal vertices of a face by comparing every pair.
constexpr int kMaxCornersOfAFace = 5000;

/// pattern: with a placeholder for the line.
Prepared damagedAt(int line, const char* pattern) {
  Prepared none;
  none.problem = phrase(pattern, {std::to_string(line)});
  return none;
}

/// One facet of an STL text, from after its word "facet" on; the problem as a pattern for its line, or null.
const char* addFacet(Scan& words, std::string& to, Shift& shift) {
  const auto is = [&words](const char* word) { return mesh_file::lowered(words.word()) == word; };
  const auto ends = [&words](const std::string& what) {  // "endloop", or "end loop"
    const std::string word = mesh_file::lowered(words.word());
    return (word == "end" ? word + mesh_file::lowered(words.word()) : word) == "end" + what;
  };
  to += "facet normal ";
  if (!is("normal") || !addPoint(words, to))
    return TRANSLATE_NOOP("problem", "The file is damaged: line %1 is not the normal of a face.");
  if (!is("outer") || !is("loop"))
    return TRANSLATE_NOOP("problem",
                          "The file is damaged: line %1 does not begin the vertices of a face (outer loop).");
  to += "outer loop\n";
  for (int corner = 0; corner < 3; ++corner) {
    to += "vertex ";
    if (!is("vertex") || !addPoint(words, to, &shift))
      return TRANSLATE_NOOP("problem", "The file is damaged: line %1 is not a vertex of a face (vertex x y z).");
  }
  if (!ends("loop"))
    return TRANSLATE_NOOP("problem",
                          "The file is damaged: line %1 does not end the three vertices of a face (endloop).");
  if (!ends("facet")) return TRANSLATE_NOOP("problem", "The file is damaged: line %1 does not end a face (endfacet).");
  to += "endloop\nendfacet\n";
  return nullptr;
}

/// A mesh further than this many times its extent from its origin is moved: floats would lose 6 of their 24 bits there.
constexpr double kFarOff = 32.0;

/// The point to move to the origin, near the middle of the mesh; 0: it may stay. In steps of about the extent, so that
/// floats of the file are still exact after the move.
Vec3 originOf(const Shift& shift) {
  const double extent = (shift.high_M - shift.low_M).maxCoeff();
  const double largest = std::max(shift.low_M.cwiseAbs().maxCoeff(), shift.high_M.cwiseAbs().maxCoeff());
  if (!(extent > 0.0) || !std::isfinite(largest) || !(largest > kFarOff * extent)) return Vec3::Zero();
  const double step = std::ldexp(1.0, std::ilogb(extent));
  const Vec3 steps = (0.5 / step) * (shift.low_M + shift.high_M);
  return step * Vec3(std::round(steps.x()), std::round(steps.y()), std::round(steps.z()));
}

/// Makes a binary STL one of plain faces, as many as it has: behind each may be attributes, whose length its last two
/// bytes state, though others have a colour there; and the stated number may be wrong. Gives the number of faces; none:
/// its length fits neither.
std::optional<std::size_t> withPlainFaces(std::string& bytes) {
  using mesh_file::kStlFaceBytes, mesh_file::kStlHeadBytes;
  const std::size_t stated = mesh_file::stlBinaryCount(bytes), count = (bytes.size() - kStlHeadBytes) / kStlFaceBytes;
  const bool are_whole = bytes.size() == kStlHeadBytes + count * kStlFaceBytes;
  if (are_whole && count == stated) return stated;
  std::string plain = bytes.substr(0, kStlHeadBytes);
  std::size_t at = kStlHeadBytes;
  for (std::size_t face = 0; face < stated && at + kStlFaceBytes <= bytes.size(); ++face) {
    plain.append(bytes, at, kStlFaceBytes);
    at = at + kStlFaceBytes + static_cast<unsigned char>(bytes[at + 48]) +
         256U * static_cast<unsigned char>(bytes[at + 49]);
  }
  const bool are_all = stated > 0 && plain.size() == kStlHeadBytes + stated * kStlFaceBytes;
  if (are_whole && !(are_all && at == bytes.size())) {
    for (unsigned k = 0; k < 4; ++k) bytes[80 + k] = static_cast<char>(count >> 8U * k);
    return count;
  }
  if (!are_all || (at != bytes.size() && at != plain.size())) return {};
  bytes = std::move(plain);
  return stated;
}

Prepared preparedAt(mesh_file::Format format, std::string bytes, Shift& shift) {
  switch (format) {
    case mesh_file::Format::StlBinary:
      return prepareStlBinary(std::move(bytes), shift);
    case mesh_file::Format::StlText:
      return prepareStlText(bytes, shift);
    case mesh_file::Format::Obj:
      return prepareObj(bytes, shift);
    case mesh_file::Format::Ply:
      return preparePly(bytes, shift);
    case mesh_file::Format::Off:
      return prepareOff(bytes, shift);
  }
  return {};
}

}  // namespace

Prepared prepareStlBinary(std::string bytes, Shift& shift) {
  Prepared prepared;
  const auto faces = bytes.size() < mesh_file::kStlHeadBytes ? std::nullopt : withPlainFaces(bytes);
  prepared.faces = faces.value_or(0);
  shift.is_single = true;
  if (!faces) {
    prepared.problem = phrase(TRANSLATE_NOOP("problem", "The file is damaged: its length does not fit its faces."));
    return prepared;
  }
  for (std::uint64_t face = 0; face < prepared.faces; ++face) {
    char* at = bytes.data() + mesh_file::kStlHeadBytes + face * mesh_file::kStlFaceBytes + 12;
    for (int number = 0; number < 9; ++number, at += 4) {
      float value = 0.0F;
      std::memcpy(&value, at, 4);
      if (!(std::abs(value) < mesh_file::kBeyondAll)) {
        std::memcpy(at, &kNoNumberValue, 4);
      } else if (const auto moved = static_cast<float>(shift.take(number % 3, static_cast<double>(value)));
                 moved != value) {
        std::memcpy(at, &moved, 4);
      }
    }
  }
  prepared.bytes = std::move(bytes);
  return prepared;
}

Prepared prepareStlText(const std::string& bytes, Shift& shift) {
  Prepared prepared;
  prepared.bytes.reserve(bytes.size() + 64);
  prepared.bytes = "solid\n";
  Scan words(bytes);
  for (;;) {
    const std::string word = mesh_file::lowered(words.word());
    if (word.empty()) break;
    if (word == "solid" || word == "endsolid" || word == "end") {
      words.line();  // a name, which OpenMesh would misread
    } else if (word == "facet") {
      const char* problem = addFacet(words, prepared.bytes, shift);
      if (problem != nullptr) return damagedAt(words.lineNumber(), problem);
      ++prepared.faces;
    } else {
      return damagedAt(words.lineNumber(),
                       TRANSLATE_NOOP("problem", "The file is damaged: line %1 does not begin a face (facet)."));
    }
  }
  prepared.bytes += "endsolid\n";
  return prepared;
}

Prepared prepareObj(const std::string& bytes, Shift& shift) {
  Prepared prepared;
  prepared.bytes.reserve(bytes.size() + 64);
  std::string joined;
  for (Scan lines(bytes); !lines.atEnd();) {
    std::string_view line = lines.line();
    if (line.ends_with('\\')) {  // it continues on the next one
      joined = line;
      while (joined.ends_with('\\') && !lines.atEnd()) {
        joined.back() = ' ';
        joined += lines.line();
      }
      line = joined;
    }
    Scan words(line);
    const std::string_view key = words.word();
    if (key == "v") {
      prepared.bytes += "v ";
      if (!addPoint(words, prepared.bytes, &shift))
        return damagedAt(lines.lineNumber() - 1,
                         TRANSLATE_NOOP("problem", "The file is damaged: line %1 is not a vertex (v x y z)."));
      ++prepared.corners;
    } else if (key == "f") {
      prepared.bytes += "f ";
      int count = 0;
      for (std::string_view word = words.word(); !word.empty() && !word.starts_with('#'); word = words.word()) {
        std::int32_t index = 0;  // of the vertex; after a / come those of its texture and normal
        const bool is_number = mesh_file::readInteger(word.substr(0, word.find('/')), index);
        if (!is_number || ++count > kMaxCornersOfAFace)
          return damagedAt(lines.lineNumber() - 1,
                           TRANSLATE_NOOP("problem", "The file is damaged: line %1 is not a face."));
        prepared.bytes += std::to_string(index) + ' ';
      }
      prepared.bytes.back() = '\n';
      ++prepared.faces;
    }
  }
  return prepared;
}

Prepared prepareOff(const std::string& bytes, Shift& shift) {
  const Result<mesh_file::OffHeader> header = mesh_file::readOffHeader(bytes);
  Prepared prepared;
  if (!header) {
    prepared.problem = header.problems()[0].sentence;
    return prepared;
  }
  prepared.corners = header.value().corners;
  prepared.faces = header.value().faces;
  prepared.bytes.reserve(bytes.size() + 64);
  prepared.bytes = "OFF\n" + std::to_string(prepared.corners) + ' ' + std::to_string(prepared.faces) + " 0\n";
  Scan lines(std::string_view(bytes).substr(header.value().bytes));
  for (std::uint64_t row = 0; row < prepared.corners + prepared.faces;) {
    const std::string_view line = lines.line();
    const int number = header.value().lines + lines.lineNumber() - 2;
    Scan words(line.substr(0, line.find('#')));
    const std::string_view first = words.word();
    if (first.empty()) {
      if (lines.atEnd())
        return damagedAt(
            number + 1,
            TRANSLATE_NOOP("problem", "The file is damaged: it ends at line %1, and vertices or faces are missing."));
      continue;
    }
    if (row++ < prepared.corners) {
      Scan again(line);
      if (!addPoint(again, prepared.bytes, &shift))
        return damagedAt(number, TRANSLATE_NOOP("problem", "The file is damaged: line %1 is not a vertex (x y z)."));
      continue;
    }
    int count = 0;
    if (!mesh_file::readInteger(first, count) || count < 0 || count > kMaxCornersOfAFace) {
      return damagedAt(number, TRANSLATE_NOOP("problem", "The file is damaged: line %1 is not a face."));
    }
    prepared.bytes += std::to_string(count) + ' ';
    for (int corner = 0; corner < count; ++corner) {
      std::int32_t index = 0;
      if (!mesh_file::readInteger(words.word(), index))
        return damagedAt(number, TRANSLATE_NOOP("problem", "The file is damaged: line %1 is not a face."));
      prepared.bytes += std::to_string(index < 0 ? INT32_MAX : index) + ' ';
    }
    prepared.bytes.back() = '\n';
  }
  return prepared;
}

Prepared prepare(mesh_file::Format format, std::string bytes) {
  Shift shift;
  // Binary STL is moved in place; other files are prepared a second time if they turn out to be far from the origin.
  const bool is_in_place = format == mesh_file::Format::StlBinary;
  Prepared prepared = preparedAt(format, is_in_place ? std::move(bytes) : bytes, shift);
  const Vec3 origin_M = prepared.problem.empty() ? originOf(shift) : Vec3(Vec3::Zero());
  if (origin_M == Vec3::Zero()) return prepared;
  Shift moved;
  moved.origin_M = origin_M;
  prepared = preparedAt(format, is_in_place ? std::move(prepared.bytes) : std::move(bytes), moved);
  prepared.origin_M = origin_M;
  const double largest = std::max(shift.low_M.cwiseAbs().maxCoeff(), shift.high_M.cwiseAbs().maxCoeff());
  if (shift.is_single) prepared.single_step = std::ldexp(1.0, std::ilogb(largest) - 23);  // floats have 24 bits
  return prepared;
}

}  // namespace underact::mesh_reader
