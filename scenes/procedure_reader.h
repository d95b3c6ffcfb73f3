#pragma once
/// The [[procedure]] tables of a scene file.
#include <string>
#include <vector>

#include "scenes/toml_input.h"

namespace halsted::scenes {

/// Throws InputError naming file, line and key: unknown key or quantity, missing id or condition, repeated id, too many steps.
std::vector<ProcedureStep> readProcedure(const toml::node& node, const std::string& origin);

}  // namespace halsted::scenes
