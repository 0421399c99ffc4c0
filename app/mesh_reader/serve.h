#pragma once
#include <string>

namespace underact::mesh_reader {

/// Reads the mesh at the standard input, a file, and writes progress and one message to the standard output; sealed
/// before the first byte is read. format: its name. Returns the exit status.
int serve(const std::string& format);

}  // namespace underact::mesh_reader
