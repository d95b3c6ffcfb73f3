#include "tests/lint/rules.h"

#include <regex>

namespace halsted::lint {
namespace {

void add(const SourceFile& file, int line, const std::string& what, Findings& findings) {
  findings.push_back(file.path + ":" + std::to_string(line) + ": " + what);
}

std::string folderOf(const std::string& path) { return path.substr(0, path.find('/')); }
bool isHeader(const SourceFile& file) { return file.path.ends_with(".h"); }

/// Headers whose names another interface gives: programs include <HD/hdDevice.h> and call getInverse.
bool namedElsewhere(const SourceFile& file) { return file.path.starts_with("haptics/hd/include/"); }

void checkSizes(const SourceFile& file, Findings& findings) {
  const int lines = static_cast<int>(file.raw.size());
  if (lines > kMaxFileLines) add(file, kMaxFileLines + 1, "file-size: " + std::to_string(lines) + " lines", findings);
  for (const Block& block : blocks(file)) {
    const int length = block.lastLine - block.firstLine + 1;
    if (block.kind == BlockKind::kFunction && length > kMaxFunctionLines)
      add(file, block.firstLine, "function-size: " + std::to_string(length) + " lines", findings);
    if (block.kind == BlockKind::kControl && block.controlDepth == kMaxNesting + 1)
      add(file, block.firstLine, "nesting: deeper than " + std::to_string(kMaxNesting), findings);
  }
}

/// The link lines of CMake, seen in the includes: sim <- haptics, render, scenes <- app.
bool includeAllowed(const std::string& folder, const std::string& included) {
  const std::string from = folderOf(included);
  if (folder == "tests" || folder == "app" || from == folder) return true;
  if (folder == "render") return included == "sim/exchange.h" || included == "sim/types.h";   // snapshots, never physics
  return (folder == "haptics" || folder == "scenes") && from == "sim";
}

bool systemIncludeForbidden(const std::string& folder, const std::string& name) {
  static const std::regex kNeverInSim("chrono|thread|random|unordered_.*|iostream|fstream|mutex|condition_variable|ctime|time.h");
  static const std::regex kAppOnly("chrono|thread|mutex|condition_variable|spdlog/.*|sqlite3.h");
  if (folder == "sim") return std::regex_match(name, kNeverInSim) || (name.find('/') != std::string::npos && name.rfind("Eigen/", 0) != 0);
  if (folder == "haptics" || folder == "render" || folder == "scenes") return std::regex_match(name, kAppOnly);
  return folder == "app" && (name == "mutex" || name == "condition_variable");
}

void checkIncludes(const SourceFile& file, Findings& findings) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*(["<])([^">]+)[">])");
  const std::string folder = folderOf(file.path);
  for (int i = 0; i < static_cast<int>(file.raw.size()); ++i) {
    std::smatch match;
    if (!std::regex_search(file.raw[i], match, kInclude)) continue;
    const bool own = match[1] == "\"";
    if (own ? !includeAllowed(folder, match[2]) : systemIncludeForbidden(folder, match[2]))
      add(file, i + 1, "include: " + folder + "/ must not include " + match[2].str(), findings);
  }
}

/// Calls whose bits or timing differ between machines. Transcendental functions may run while loading: the line, or one of the
/// file's first lines, says "load time".
void checkSimCalls(const SourceFile& file, Findings& findings) {
  if (folderOf(file.path) != "sim") return;
  static const std::regex kNever(R"(\b(rand|srand|time|clock|fma|printf|puts)\s*\(|\bstd::(fma|rand|cout|cerr|async|thread)\b)");
  static const std::regex kLibm(
      R"((^|[^\w.>:])(std::)?(sin|cos|tan|asin|acos|atan|atan2|exp|exp2|log|log2|log10|pow|cbrt|hypot|sinh|cosh|tanh|erf)\s*\()");
  static const std::regex kMarked("load time", std::regex::icase);
  bool wholeFile = false;
  for (int i = 0; i < std::min(12, static_cast<int>(file.comment.size())); ++i)
    wholeFile = wholeFile || std::regex_search(file.comment[i], kMarked);
  for (int i = 0; i < static_cast<int>(file.code.size()); ++i) {
    if (std::regex_search(file.code[i], kNever)) add(file, i + 1, "sim-call: not allowed inside a step", findings);
    if (!wholeFile && std::regex_search(file.code[i], kLibm) && !std::regex_search(file.comment[i], kMarked))
      add(file, i + 1, "libm: differs between CPUs; only at load time, and the line or file header says so", findings);
  }
}

bool unitNearby(const SourceFile& file, int line) {
  static const std::regex kUnit(R"(\[[^\]]+\])");
  if (std::regex_search(file.comment[line], kUnit)) return true;
  // The comment block right above a declaration counts too, over the other lines of the same declaration.
  for (int i = line - 1; i >= 0 && i >= line - 12; --i) {
    const bool commentOnly = file.code[i].find_first_not_of(' ') == std::string::npos;
    const bool sameDeclaration = !commentOnly && file.code[i].find_first_of(";{}") == std::string::npos;
    if (!commentOnly && !sameDeclaration) return false;
    if (commentOnly && file.raw[i].find_first_not_of(' ') == std::string::npos) return false;
    if (std::regex_search(file.comment[i], kUnit)) return true;
  }
  return false;
}

void checkUnits(const SourceFile& file, Findings& findings) {
  if (!isHeader(file) || folderOf(file.path) == "tests" || namedElsewhere(file)) return;
  static const std::regex kField(R"(^\s*(static |inline |constexpr |const |mutable )*(std::(vector|array|span|atomic)<(const )?)?(double|float)\b[^()]*;)");
  static const std::regex kParameter(R"([(,]\s*(const )?(double|float)\s+\w+\s*(=[^,)]*)?[,)])");
  for (int i = 0; i < static_cast<int>(file.code.size()); ++i) {
    const bool declares = std::regex_search(file.code[i], kField) || std::regex_search(file.code[i], kParameter);
    if (declares && !unitNearby(file, i)) add(file, i + 1, "unit: floating point without [unit]", findings);
  }
}

void checkNames(const SourceFile& file, Findings& findings) {
  static const std::regex kFileName(R"([a-z0-9_]+\.(h|cpp))"), kGetter(R"(\bget[A-Z]\w*\s*\()");
  static const std::regex kVague(R"(\b(class|struct)\s+\w+(Manager|Helper|Util|Utils|Base|Impl)\b)");
  static const std::regex kLeftover("\\b(TO" "DO|FIX" "ME|X" "XX|HA" "CK)\\b");
  const std::string fileName = file.path.substr(file.path.rfind('/') + 1);
  const bool own = !namedElsewhere(file);
  if (own && !std::regex_match(fileName, kFileName)) add(file, 1, "file-name: not snake_case", findings);
  for (int i = 0; i < static_cast<int>(file.code.size()); ++i) {
    if (own && isHeader(file) && std::regex_search(file.code[i], kGetter)) add(file, i + 1, "name: no get prefix", findings);
    if (std::regex_search(file.code[i], kVague)) add(file, i + 1, "name: vague type name", findings);
    if (std::regex_search(file.raw[i], kLeftover)) add(file, i + 1, "leftover: unfinished work belongs in an issue", findings);
  }
}

void checkOutcome(const SourceFile& file, Findings& findings) {
  static const std::regex kLocks(R"(\bstd::(recursive_|shared_|timed_)?(mutex|lock_guard|unique_lock|scoped_lock|condition_variable)\b)");
  static const std::regex kOptimise(R"(#\s*pragma\s+(GCC\s+optimize|clang\s+fp|STDC\s+FP_CONTRACT)|__attribute__\s*\(\(\s*optimize)");
  const bool product = folderOf(file.path) != "tests";
  for (int i = 0; i < static_cast<int>(file.code.size()); ++i) {
    if (product && std::regex_search(file.code[i], kLocks)) add(file, i + 1, "lock: threads talk through carriers", findings);
    if (std::regex_search(file.code[i], kOptimise)) add(file, i + 1, "flags: changes the bits", findings);
  }
}

}  // namespace

void checkSource(const SourceFile& file, Findings& findings) {
  checkSizes(file, findings);
  checkIncludes(file, findings);
  checkSimCalls(file, findings);
  checkUnits(file, findings);
  checkNames(file, findings);
  checkOutcome(file, findings);
}

void checkBuildFile(const SourceFile& file, Findings& findings) {
  static const std::regex kFlags("-ffast" "-math|-O" "fast|-mf" "ma|-march" "=|-mtune" "=native|-funsafe" "-math|-mavx" "|-ffp-contract" "=(on|fast)");
  for (int i = 0; i < static_cast<int>(file.raw.size()); ++i) {
    const std::string& line = file.raw[i];
    const std::size_t hash = line.find('#');
    const std::string code = file.path.ends_with(".json") ? line : line.substr(0, hash);
    if (std::regex_search(code, kFlags)) add(file, i + 1, "flags: changes the bits", findings);
  }
}

}  // namespace halsted::lint
