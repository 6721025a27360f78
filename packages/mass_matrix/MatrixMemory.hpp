#pragma once
/// Whether a mass matrix fits into the machine.

namespace Rhegma::mass_matrix
{

/// Throws std::invalid_argument with the reason where a matrix needs more than there is. Linux overcommits
/// memory and ends the program when it is used, so this is checked before. \param rows of the matrix \param
/// bytesPerRow of the matrix and of the vectors of its solves \param available [bytes] \param instead what
/// the scene could have instead
void refuseLargeMatrix(double rows, double bytesPerRow, double available, const char* instead);

} // namespace Rhegma::mass_matrix
