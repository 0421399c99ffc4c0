#pragma once
#include <memory>
#include <string>

#include "tests/contract/far_side.h"

namespace underact::test {

// A driver a function; each in a file of its own.
std::unique_ptr<FarSide> simulatedFarSide(std::string& why);
std::unique_ptr<FarSide> replayedFarSide(std::string& why);
std::unique_ptr<FarSide> openHapticsFarSide(std::string& why);
std::unique_ptr<FarSide> woodenV1FarSide(std::string& why);
std::unique_ptr<FarSide> woodenV2FarSide(std::string& why);
std::unique_ptr<FarSide> woodenTeensyFarSide(std::string& why);
std::unique_ptr<FarSide> remoteFarSide(std::string& why);
std::unique_ptr<FarSide> haplyFarSide(std::string& why);
std::unique_ptr<FarSide> haplyOldFarSide(std::string& why);
std::unique_ptr<FarSide> woodenUhidV1FarSide(std::string& why);
std::unique_ptr<FarSide> woodenUhidV2FarSide(std::string& why);

}  // namespace underact::test
