#include "app/commands/usage_error.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace halsted::app {
namespace {

/// Damerau 1964, restricted: letters left out, put in, changed, or two neighbours exchanged.
std::size_t typingErrors(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) least[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) least[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      least[i][j] = std::min({least[i - 1][j] + 1, least[i][j - 1] + 1, least[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
    }
  return least[a.size()][b.size()];
}

const CLI::App& deepestCommand(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  return *at;
}

std::vector<std::string> commandsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> optionsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::string nearestWord(const std::string& typed, const std::vector<std::string>& known) {
  std::size_t fewest = 1 + typed.size() / 3;             // more than that is another word
  std::string nearest;
  for (const std::string& word : known)
    if (const std::size_t errors = typingErrors(typed, word); errors < fewest || (nearest.empty() && errors == fewest)) {
      fewest = errors;
      nearest = word;
    }
  return nearest;
}

std::string usageLine(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = deepestCommand(app);
  const std::string call = &command == &app ? "halsted" : "halsted " + command.get_name();
  const std::vector<std::string> unknown = app.remaining(true);
  if (unknown.empty()) return std::string(error.what()) + " (" + call + " --help)";
  const std::string typed = unknown.front().substr(0, unknown.front().find('='));
  const bool option = typed.size() > 1 && typed[0] == '-';
  const std::vector<std::string> known = option ? optionsOf(command) : commandsOf(command);
  const std::string nearest = nearestWord(typed, known);
  std::string line = (option ? "unknown option " : known.empty() ? "one argument too many: " : "unknown command ") + typed;
  if (!nearest.empty()) line += "; did you mean " + nearest + "?";
  else if (!option && !known.empty()) line += "; there are " + listed(known);
  return line + " (" + call + " --help)";
}

}  // namespace halsted::app
