#include "app/commands/number_range.h"

#include <charconv>
#include <cmath>

#include "scenes/input_text.h"

namespace halsted::app {

CLI::Validator numberFrom(double least, double most) {
  const std::string range = scenes::plainNumber(least) + " to " + scenes::plainNumber(most);
  const auto check = [least, most, range](const std::string& text) -> std::string {
    double value = 0.0;                        // [unit of the option]
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range) return scenes::quoted(text) + " is not " + range;
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return scenes::quoted(text) + " is not a number";
    return value >= least && value <= most ? std::string() : scenes::quoted(text) + " is not " + range;
  };
  return CLI::Validator(check, "[" + range + "]", "NUMBER");
}

}  // namespace halsted::app
