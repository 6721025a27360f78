#pragma once
/// Laws of shared libraries that end the program.

namespace Rhegma::program
{

/// From now on, if a law calls exit() (STOP of Fortran) or crashes, the program says which law it was, and
/// ends with a status of failure, on all ranks. Call once, after MPI_Init, whose handlers of signals stay for
/// crashes elsewhere.
/// \param status exit status
void sayWhichLawEnds(int status);

} // namespace Rhegma::program
