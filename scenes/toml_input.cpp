#include "scenes/toml_input.h"

#include <stdexcept>

#include "scenes/toml_guard.h"

namespace halsted::scenes {

toml::table parseToml(const std::string& text, const std::string& origin) {
  const std::string ascii = asciiToml(text, origin);
  try {
    return toml::parse(ascii, origin);
  } catch (const toml::parse_error& error) {
    throw InputError(quoted(origin) + ":" + std::to_string(error.source().begin.line) + ": " +
                     quoted(std::string(error.description())));
  } catch (const std::logic_error&) {
    throw InputError(quoted(origin) + ": is not TOML");
  }
}

void tomlAssertionFailed(const char* expression) { throw std::logic_error(expression); }

std::string whereIs(const std::string& origin, const toml::node& node, const std::string& key) {
  return quoted(origin) + ":" + std::to_string(node.source().begin.line) + ": " + quoted(key);
}

const char* kindOf(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "a list";
    case toml::node_type::string: return "a text";
    case toml::node_type::integer: return "an integer";
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "true or false";
    default: return "a date or time";
  }
}

double requireNumber(const toml::node& node, const std::string& where) {
  if (!node.is_number()) throw InputError(where + ": must be a number, is " + kindOf(node));
  return *node.value<double>();
}

std::string requireText(const toml::node& node, const std::string& where) {
  if (!node.is_string()) throw InputError(where + ": must be a text in quotes, is " + kindOf(node));
  return *node.value<std::string>();
}

}  // namespace halsted::scenes
