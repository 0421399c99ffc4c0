#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "core/base/sentence.h"
#include "core/mesh_file/raw.h"

namespace underact::mesh_file {

/// What the reader writes to its standard output: bytes of progress, see helper/run.h, then one message.
struct Message {
  Sentence problem;  // empty: the file was read
  RawMesh raw;
};

/// Writes it part by part, of the problem the pattern and the words in its places. false: the callback returned false.
bool writeMessage(const Message& message, const std::function<bool(std::span<const std::byte>)>& write);

/// bytes: from the first one after the progress. Nothing is trusted: counts are checked against the length, and
/// indexes, coordinates and words too. None: not a valid message.
std::optional<Message> readMessage(std::span<const std::byte> bytes);

}  // namespace underact::mesh_file
