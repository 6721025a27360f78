#pragma once
/// What a fuzzer and the test that replays its corpus feed with bytes.

#include <cstddef>
#include <cstdint>

namespace Rhegma::fuzz
{

/// Reads a scene as the program would. Bytes up to the first 0 are the XML; what follows it are overrides,
/// one a line. Whatever the bytes are, mistakes come as sentences: an exception is a finding.
void readScene(const std::uint8_t* bytes, std::size_t size);

/// Reads a checkpoint. An even first byte: the others are the file as it is. An odd one: they are what
/// follows the first block of the file, which is made so that all checksums are right; else nothing behind
/// these would ever be reached. \return whether it was read; std::invalid_argument with a message counts as
/// refused
bool readCheckpoint(const std::uint8_t* bytes, std::size_t size);

} // namespace Rhegma::fuzz
