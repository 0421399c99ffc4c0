#pragma once
#include <string>
#include <vector>

#include "core/scene/settings.h"

namespace underact::guide {

/// Where a setting is at home.
struct SettingUse {
  std::vector<std::string> of;  // types of constraints, of joints or filters that have it
  bool is_of_all = false;
  scene::SettingValue default_value;  // none: the key cannot be left out, or what stands for it depends on the rest
};
SettingUse useOf(const scene::Setting& setting);

/// A section of a page: every setting of a scene by its path, from the table of settings.
std::string settingTable();

}  // namespace underact::guide
