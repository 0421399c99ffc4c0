#pragma once
#include "app/options/described.h"

namespace underact::describe {

using Option = options::DescribedOption;
using Command = options::DescribedCommand;

}  // namespace underact::describe
