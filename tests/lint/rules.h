#pragma once
/// The rules of DESIGN 3, 7 and 9 that a program can check by reading. Each appends "file:line: rule: what" lines.
#include <string>
#include <vector>

#include "tests/lint/source_file.h"

namespace halsted::lint {

using Findings = std::vector<std::string>;

inline constexpr int kMaxFileLines = 300, kMaxFunctionLines = 60, kMaxNesting = 3;

/// Every rule that applies to a C++ file at this path.
void checkSource(const SourceFile&, Findings&);
/// Build files: no flag that changes the bits.
void checkBuildFile(const SourceFile&, Findings&);

}  // namespace halsted::lint
