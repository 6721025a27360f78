#include "../Entries.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  Rhegma::fuzz::readCheckpoint(bytes, size);
  return 0;
}
