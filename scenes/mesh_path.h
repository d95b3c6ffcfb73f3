#pragma once
/// Which mesh files a scene may open: a path on the command line is the user's word, a path inside a file stays inside that
/// scene's folder or HALSTED_DATA.
#include <string>

namespace halsted::scenes {

/// The value of HALSTED_DATA, or empty.
std::string dataFolder();

/// A path written inside scene.toml: relative to `folder`, else to HALSTED_DATA ("$HALSTED_DATA/..." says so). Symbolic links are
/// followed before the check. Throws InputError "where: ..." when it leaves both or names no file.
std::string meshPathInFile(const std::string& text, const std::string& folder, const std::string& where);

/// A path given on the command line, relative to the current folder. Throws InputError "where: ..." when it names no file.
std::string meshPathFromUser(const std::string& text, const std::string& where);

}  // namespace halsted::scenes
