#include "material/LoadedLaw.hpp"

#include "material/LawTrial.hpp"
#include "material/LibraryFile.hpp"
#include "material/SharedLawBlock.hpp"

#include <algorithm>
#include <cctype>
#include <deque>
#include <dlfcn.h>

namespace Rhegma
{

namespace
{

/// What the interface of a law stores in front of its state variables.
constexpr int strainOfUmat = 6;

bool isSame(const LawRequest& a, const LawRequest& b)
{
  return a.file == b.file && a.behaviour == b.behaviour && a.interface == b.interface &&
         a.constants == b.constants && a.states == b.states;
}

/// With what is behind its constants: zeros, so that a law that reads on has the same result in each run.
struct KeptLaw : LoadedLaw
{
  std::vector<double> constants;
};

/// Of all scenes. Never destroyed: it says which law ended the process.
std::deque<KeptLaw>& laws()
{
  static auto& all = *new std::deque<KeptLaw>;
  return all;
}

/// The first of some symbols that a library has.
void* find(void* library, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
    if (void* found = dlsym(library, name.c_str()))
      return found;
  return nullptr;
}

/// Names under which compilers of Fortran and C store a function.
std::vector<std::string> storedNames(const LawRequest& request)
{
  const std::string& name = request.behaviour;
  if (request.interface == LawInterface::Generic)
    return {name + "_Tridimensional"};
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return {name, name + "_", lower, lower + "_"};
}

/// Descriptions of a law in its library, by names of MFront, such as NAME_nMaterialProperties. All are
/// optional.
struct Descriptions
{
  void* library;
  std::string name;

  void* at(const std::string& what) const
  {
    return find(library, {name + "_Tridimensional_" + what, name + "_" + what});
  }
  /// A number; -1 if it is not there.
  int number(const std::string& what) const
  {
    const auto* found = static_cast<const unsigned short*>(at(what));
    return found != nullptr ? *found : -1;
  }
  /// "; they are a, b, c" of an array of names; empty if it is not there.
  std::string names(const std::string& what, int count) const
  {
    const auto* found = static_cast<const char* const*>(at(what));
    constexpr int most = 30;
    std::string all;
    for (int k = 0; found != nullptr && k < std::min(count, most) && found[k] != nullptr; ++k)
      all += (k == 0 ? ": " : ", ") + std::string(found[k]);
    return count > most && !all.empty() ? all + ", ..." : all;
  }
  /// Numbers of all state variables, some of which are tensors; -1 if the library does not say.
  int stateNumbers() const
  {
    const int count = number("nInternalStateVariables");
    const auto* types = static_cast<const int*>(at("InternalStateVariablesTypes"));
    if (count < 0 || types == nullptr)
      return count;
    constexpr int size[4] = {1, 6, 3, 9}; // scalar, symmetric tensor, vector, tensor
    int sum = 0;
    for (int k = 0; k < count; ++k)
      sum += size[types[k] & 3];
    return sum;
  }
};

std::string counted(std::size_t number, const char* what)
{
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

void checkConstants(const Descriptions& has, const LawRequest& request)
{
  const int wanted = has.number("nMaterialProperties");
  if (wanted >= 0 && wanted != static_cast<int>(request.constants.size()))
    throw LawRefused("Constants", "has " + counted(request.constants.size(), "number") + ", but " +
                                      request.behaviour + " needs " + std::to_string(wanted) +
                                      has.names("MaterialProperties", wanted) +
                                      "; give one number for each.");
}

int stateVariables(const Descriptions& has, const LawRequest& request)
{
  const int said = has.stateNumbers();
  if (said >= 0 && request.states >= 0 && said != request.states)
    throw LawRefused("State Variables", "is " + std::to_string(request.states) + ", but " +
                                            request.behaviour + " has " + std::to_string(said) +
                                            "; give that number or leave the parameter out.");
  const int states = said >= 0 ? said : request.states;
  if (states < 0)
    throw LawRefused("State Variables", "is missing, and the library does not say how many " +
                                            request.behaviour + " has; give the number, or 0.");
  if (states > mostStateVariables)
    throw LawRefused("State Variables", "is " + std::to_string(states) + "; at most " +
                                            std::to_string(mostStateVariables) + " are possible.");
  return states;
}

void setGeneric(const Descriptions& has, LoadedLaw& law)
{
  const int type = has.number("BehaviourType");
  if (type > 2)
    throw LawRefused("Behaviour", "\"" + law.of.behaviour +
                                      "\" is not a law of a solid; give one that takes the strain or the "
                                      "deformation gradient.");
  law.smallStrain = type == 1;
}

} // namespace

int foundLaw(const LawRequest& request)
{
  for (std::size_t k = 0; k < laws().size(); ++k)
    if (isSame(laws()[k].of, request))
      return static_cast<int>(k);
  return -1;
}

int loadLaw(const LawRequest& request)
{
  if (const int number = foundLaw(request); number >= 0)
    return number;
  KeptLaw law;
  law.of = request;
  law.constants = request.constants;
  law.constants.resize(request.constants.size() + lawSlack, 0.0);
  void* const library = openLibrary(request.file);
  const std::vector<std::string> names = storedNames(request);
  law.function = find(library, names);
  if (law.function == nullptr)
  {
    std::string tried = names.front();
    for (std::size_t k = 1; k < names.size(); ++k)
      if (std::find(names.begin(), names.begin() + k, names[k]) == names.begin() + k)
        tried += (k + 1 < names.size() ? ", " : " or ") + names[k];
    throw LawRefused("Behaviour", "the library " + request.file + " has no function " + tried +
                                      "; give the name of one that it has (nm -D lists them).");
  }
  if (isVariable(law.function))
    throw LawRefused("Behaviour", "\"" + request.behaviour + "\" of the library " + request.file +
                                      " is a variable; give the name of a function (nm -D lists them with "
                                      "a T).");
  const Descriptions has{library, request.behaviour};
  checkConstants(has, request);
  law.states = stateVariables(has, request);
  law.numbers = law.states + (request.interface == LawInterface::Umat ? strainOfUmat : 0);
  law.corotational = request.interface == LawInterface::Vumat;
  law.call = request.interface == LawInterface::Vumat  ? callVumat
             : request.interface == LawInterface::Umat ? callUmat
                                                       : callGeneric;
  if (request.interface == LawInterface::Generic)
    setGeneric(has, law);
  laws().push_back(law);
  return static_cast<int>(laws().size()) - 1;
}

const LoadedLaw& loadedLaw(int number) { return laws()[number]; }

const double* constantsOf(const LoadedLaw& law) { return static_cast<const KeptLaw&>(law).constants.data(); }

} // namespace Rhegma
