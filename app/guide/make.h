#pragma once
#include <ostream>
#include <string>

namespace underact::guide {

// What underact-describe does: exit status 0; 1, and problems on `errors`, if its input is invalid;
// 4 if the output could not be written.

int printSceneSchema(const std::string& schema_file, std::ostream& out, std::ostream& errors);
int printSceneKeys(const std::string& schema_file, std::ostream& out, std::ostream& errors);
int printSceneList(const std::string& folder, std::ostream& out, std::ostream& errors);
int makeSite(const std::string& folder, const std::string& out_folder, std::ostream& errors);

}  // namespace underact::guide
