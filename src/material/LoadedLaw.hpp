#pragma once
/// Functions of constitutive laws in shared libraries, found while the program runs.

#include "material/Law.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{

struct SharedLawBlock;

/// The arguments that a law takes.
enum class LawInterface
{
  Vumat,  ///< Abaqus/Explicit: blocks of particles, in the frame of R of F = R U
  Umat,   ///< Abaqus/Standard: one particle
  Generic ///< of MFront and MGIS: one particle, the deformation gradient or the Green-Lagrange strain
};

/// A law as a scene names it.
struct LawRequest
{
  std::string file;      ///< path of the shared library
  std::string behaviour; ///< name of the function; of a Generic law without the hypothesis
  LawInterface interface = LawInterface::Vumat;
  std::vector<double> constants; ///< what the law gets as props or material properties
  int states = -1;               ///< number of state variables; -1: as the library says
};

/// A law that is in memory.
struct LoadedLaw
{
  LawRequest of;
  void* function = nullptr;
  int states = 0;            ///< state variables of the law
  int numbers = 0;           ///< the same with what its interface stores in front of them
  bool corotational = false; ///< stress is stored in the frame of R
  bool smallStrain = false;  ///< Generic: strain and stress are Green-Lagrange's and second Piola-Kirchhoff's
  /// Calls the function for the particles of a block.
  void (*call)(const LoadedLaw& law, SharedLawBlock& block) = nullptr;
};

/// A law that can't be loaded; `parameter` of the scene is wrong, what() says why and what to write.
struct LawRefused : std::runtime_error
{
  std::string parameter;
  LawRefused(std::string wrong, const std::string& why) : std::runtime_error(why), parameter(std::move(wrong))
  {
  }
};

/// Largest number of state variables of a law.
constexpr int mostStateVariables = 100;

/// Finds a law and checks its constants and state variables with what its library says of them. The same
/// request is loaded once. Not to be called by several threads. \return its number \throws LawRefused
int loadLaw(const LawRequest& request);

/// The law of a number that loadLaw returned.
const LoadedLaw& loadedLaw(int number);

/// Calls of the functions of the interfaces.
void callVumat(const LoadedLaw& law, SharedLawBlock& block);
void callUmat(const LoadedLaw& law, SharedLawBlock& block);
void callGeneric(const LoadedLaw& law, SharedLawBlock& block);

} // namespace Rhegma
