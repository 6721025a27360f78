#pragma once
/// Whether a scene fits into the memory of the machine.

namespace Rhegma
{

/// Memory that the machine, or the container that the program runs in, can still give [bytes]; infinite where
/// the system does not say.
double freeMemoryBytes();

/// Throws std::invalid_argument where a scene needs more memory than is available. Linux grants memory that
/// it does not have and kills the program when it is used; therefore this checks before.
/// \param nodes, particles  their numbers, and the memory of each [bytes]
/// \param available         [bytes]
void refuseWithoutMemory(double nodes, double bytesPerNode, double particles, double bytesPerParticle,
                         double available);

} // namespace Rhegma
