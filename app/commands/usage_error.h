#pragma once
/// What was wrong with a command line, in one line: it names what was typed and the nearest word that would have been understood.
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}

namespace halsted::app {

/// `app` has just refused to parse. Without a word that it did not know, the line is the parser's own.
std::string usageLine(const CLI::App& app, const CLI::ParseError&);

/// The one of `known` that takes the fewest typing errors to become `typed`; empty when none is near.
std::string nearestWord(const std::string& typed, const std::vector<std::string>& known);

}  // namespace halsted::app
