#pragma once
/// Files of shared libraries.

#include <string>

namespace Rhegma
{

/// Refuses what can't be a shared library for this machine, without loading it. \throws LawRefused
void checkLibraryFile(const std::string& file);

/// Loads a library, to the end of the program, after checkLibraryFile. \return its handle \throws LawRefused
void* openLibrary(const std::string& file);

/// Whether a symbol of a library is data, not a function; false where that is not known.
bool isVariable(void* symbol);

} // namespace Rhegma
