/// halsted_lint CHECKOUT: prints one "file:line: rule: what" per violation of DESIGN 3, 7 and 9; exit code 1 when there is any.
/// halsted_lint --self-test: each rule finds its violation, and clean code passes.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/lint/rules.h"

namespace fs = std::filesystem;
using namespace halsted::lint;

namespace {

std::string readText(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<fs::path> filesBelow(const fs::path& root) {
  std::vector<fs::path> found;
  for (const char* folder : {"sim", "haptics", "render", "scenes", "app", "tests", "CMakeLists.txt", "CMakePresets.json"}) {
    const fs::path path = root / folder;
    if (fs::is_regular_file(path)) found.push_back(path);
    if (!fs::is_directory(path)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file()) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

int checkTree(const fs::path& root) {
  Findings findings;
  int files = 0;
  for (const fs::path& path : filesBelow(root)) {
    const std::string relative = fs::relative(path, root).generic_string(), extension = path.extension();
    const bool source = extension == ".h" || extension == ".cpp";
    const bool build = path.filename() == "CMakeLists.txt" || path.filename() == "CMakePresets.json" || extension == ".cmake";
    if (!source && !build) continue;
    ++files;
    const SourceFile file = split(relative, readText(path));
    source ? checkSource(file, findings) : checkBuildFile(file, findings);
  }
  if (readText(root / "CMakeLists.txt").find("-ffp-contract=off") == std::string::npos)
    findings.push_back("CMakeLists.txt:1: flags: -ffp-contract=off is missing");
  for (const std::string& finding : findings) std::printf("%s\n", finding.c_str());
  std::printf("%d files, %zu findings\n", files, findings.size());
  return files > 0 && findings.empty() ? 0 : 1;
}

struct Example {
  const char *rule, *path;
  std::string text;
};

std::string functionOf(int lines) {
  std::string text = "void run() {\n";
  for (int i = 2; i < lines; ++i) text += "  work();\n";
  return text + "}\n";
}

std::vector<Example> violations() {
  return {
      {"file-size", "app/a.cpp", std::string(301, '\n') + "int a;\n"},
      {"function-size", "app/a.cpp", functionOf(61)},
      {"nesting", "app/a.cpp", "void f() { if (a) { for (;;) { while (b) { if (c) { d(); } } } } }\n"},
      {"include", "sim/a.cpp", "#include \"scenes/scene.h\"\n"},
      {"include", "render/a.cpp", "#include \"sim/model.h\"\n"},
      {"include", "sim/a.cpp", "#include <chrono>\n"},
      {"include", "haptics/a.cpp", "#include <thread>\n"},
      {"include", "app/a.cpp", "#include <mutex>\n"},
      {"sim-call", "sim/a.cpp", "double f() { return std::fma(1, 2, 3); }\n"},
      {"libm", "sim/a.cpp", "void f(double x) { y = std::sin(x); }\n"},
      {"unit", "sim/a.h", "struct A {\n  double stiffness = 3.0;\n};\n"},
      {"unit", "sim/a.h", "struct A {\n  std::vector<double> mass;\n};\n"},
      {"unit", "sim/a.h", "\nvoid f(int n, double x);\n"},
      {"file-name", "app/CamelCase.cpp", "int a;\n"},
      {"name: no get", "app/a.h", "struct A { int getSize(); };\n"},
      {"name: vague", "app/a.cpp", "class ThreadManager {};\n"},
      {"leftover", "app/a.cpp", "// TO" "DO later\n"},
      {"lock", "app/a.cpp", "std::mutex lock;\n"},
      {"flags", "sim/a.cpp", "#pragma GCC optimize(\"O3\")\n"},
      {"flags", "CMakeLists.txt", "add_compile_options(-ffast" "-math)\n"},
  };
}

const Example kClean{"", "sim/a.h",
                     "#include <cmath>\n#include \"sim/types.h\"\n/// Angle [rad].\ndouble angle(double x,\n  double y);\n"
                     "struct A {\n  double mass = 1'000.0;  // [kg]\n};\n"
                     "inline double f(const A& a) { return a.mass * 2; }  // sin(x) \"std::mutex\"\n"
                     "const char* text = \"double x; // \\\" std::mutex {\";\n"};

int selfTest() {
  int failures = 0;
  for (const Example& example : violations()) {
    Findings findings;
    const SourceFile file = split(example.path, example.text);
    std::string(example.path) == "CMakeLists.txt" ? checkBuildFile(file, findings) : checkSource(file, findings);
    const bool caught = findings.size() == 1 && findings[0].find(example.rule) != std::string::npos;
    if (!caught) std::printf("FAIL: %s not caught alone in %s (%zu findings)\n", example.rule, example.text.c_str(), findings.size());
    failures += !caught;
  }
  Findings findings;
  checkSource(split(kClean.path, kClean.text), findings);
  checkSource(split("app/a.cpp", functionOf(60)), findings);
  for (const std::string& finding : findings) std::printf("FAIL: clean code flagged: %s\n", finding.c_str());
  return failures + static_cast<int>(findings.size()) > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: halsted_lint CHECKOUT | --self-test\n");
    return 2;
  }
  return std::string(argv[1]) == "--self-test" ? selfTest() : checkTree(argv[1]);
}
