#pragma once
/// A source file as the lint rules see it: raw lines, code with comments and literals blanked, and the comments alone.
#include <string>
#include <vector>

namespace halsted::lint {

struct SourceFile {
  std::string path;                            // relative to the checkout, with '/'
  std::vector<std::string> raw, code, comment; // one entry per line; `code` and `comment` are blank where the other is not
};

SourceFile split(const std::string& path, const std::string& text);

/// A brace block; `depth` counts control blocks inside its function.
enum class BlockKind { kNamespace, kType, kFunction, kControl, kOther };
struct Block {
  BlockKind kind = BlockKind::kOther;
  int firstLine = 0, lastLine = 0;             // 1-based
  int controlDepth = 0;
};
std::vector<Block> blocks(const SourceFile&);

}  // namespace halsted::lint
