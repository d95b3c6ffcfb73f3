#pragma once
/// Puts one checked value into one field of a scene.
#include <string>

#include "scenes/scene_fields.h"
#include "scenes/toml_input.h"

namespace halsted::scenes {

/// Where a value comes from, for messages and for what it may name.
struct ValueSource {
  std::string where;            // "file:line: key" or "--set key=value"
  std::string folder;           // the scene's folder
  bool trustedPath = false;     // the user typed it
};

/// Throws InputError "where: ..." for a wrong type, a value out of range, an unknown name or a path that may not be opened.
void setField(const SceneField&, const toml::node&, const ValueSource&);

/// A value written as text after "--set key=": texts and names need no quotes.
void setFieldFromText(const SceneField&, const std::string& text, const ValueSource&);

}  // namespace halsted::scenes
