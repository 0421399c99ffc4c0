#pragma once
#include <functional>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "core/base/result.h"
#include "core/chain/chain.h"
#include "core/json/json.h"

namespace underact::cli {

/// Answers each line of the input in order, flushed one by one; an invalid one is answered {"error", "line"}, the
/// others are still answered. Keeps no state between lines.
Exit answerLines(const Streams& streams, const std::function<Result<JsonObject>(std::string_view line)>& answer);

/// A line that is an object with these keys and no others, each once; all are required but those that may lack.
/// example: for the sentence.
Result<json::Value> readLine(std::string_view text, std::initializer_list<std::string_view> keys, const char* example,
                             std::initializer_list<std::string_view> may_lack = {});

/// A finite number of magnitude 1e6 or less for each joint of the chain, or a problem: rad, or mm where it slides; the
/// values are rad and m.
Result<chain::JointValues> readJoints(const json::Value& line, const char* key, const chain::Chain& chain);

/// The numbers back as a line has them.
std::vector<double> jointNumbers(const chain::Chain& chain, const chain::JointValues& q);

/// Four rows of four; a rotation to 1e-3 (brought to the nearest one, which note says where six decimals leave less),
/// lengths in mm of at most 1e9, last row 0 0 0 1.
Result<Pose> readPose(const json::Value& line, const char* key, std::string* note);

}  // namespace underact::cli
