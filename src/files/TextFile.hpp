#pragma once
/// Text files that are replaced atomically.

#include <string>

namespace Rhegma
{

/// Writes a temporary file next to `path` and renames it to `path`. Throws OutputError when it can't.
void replaceFile(const std::string& path, const std::string& text);

} // namespace Rhegma
