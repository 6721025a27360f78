#pragma once
/// Whether a scene fits into the machine.

namespace Rhegma
{

/// Memory that the machine, or the container that the program runs in, can still give [bytes]; infinite where
/// the system does not say.
double freeMemoryBytes();

/// Throws std::invalid_argument with a sentence where a scene needs more than there is. Linux grants memory
/// that it does not have and ends the program when it is used, so this asks before.
/// \param nodes, particles  numbers of them, and what each takes [bytes]
/// \param available         [bytes]
void refuseWithoutMemory(double nodes, double bytesPerNode, double particles, double bytesPerParticle,
                         double available);

} // namespace Rhegma
