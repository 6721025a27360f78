#pragma once
/// Schema of scenes: sections and parameters with their types, units, ranges, defaults and meanings.
///
/// The same description validates a scene, fills in its defaults and prints its reference, so that none of
/// the three can differ from the others. A section is written as it would be read:
///
///     Section time("Time", "How long and how finely the run steps.");
///     time.real("Final Time").unit("s").positive().meaning("The run ends here.");
///     time.real("CFL").above(0.0).atMost(1.0).byDefault(0.4).meaning("Fraction of the stable step that is
///     used.");

#include "scene/CellNeeds.hpp"
#include "scene/Compatibility.hpp"
#include "scene/SceneError.hpp"
#include "scene/UnitConversion.hpp"

#include <Teuchos_ParameterList.hpp>

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace Rhegma
{

enum class ParameterType
{
  Real,
  Integer,
  Boolean,
  Text,
  Choice,       ///< a text out of a few
  RealArray,    ///< Teuchos::Array<double>
  IntegerArray, ///< Teuchos::Array<int>
  TimeFunction  ///< a text: an expression of t or a table (scene/TimeFunction.hpp)
};

/// A default value. Text, Choice and TimeFunction are strings.
using ParameterValue = std::variant<double, int, bool, std::string, std::vector<double>, std::vector<int>>;

/// Number of values of an array; some lengths follow the scene's dimension D.
struct ArrayLength
{
  enum class Rule
  {
    Any,
    Exactly,        ///< `number`
    MultipleOf,     ///< `number`
    Axes,           ///< D
    MultipleOfAxes, ///< points one after another: a multiple of D
    RotationAxes    ///< 1 in 2D, 3 in 3D
  };
  Rule rule = Rule::Any;
  int number = 0;
  int atLeast = 0; ///< fewest values; with MultipleOfAxes fewest points

  /// Whether an array of n values fits; an unknown dimension (0) fits every rule that needs it.
  bool holds(int n, int dimension) const;
  /// The rule as text, such as "2 numbers"; in general terms with dimension 0.
  std::string asText(int dimension) const;
};

struct Parameter
{
  std::string name;
  ParameterType type = ParameterType::Real;
  std::string unit;                                        ///< SI; empty: a pure number or not a number
  TemperatureKind temperature = TemperatureKind::Absolute; ///< where the unit is K
  std::string meaning;
  std::vector<std::string>
      formerNames; ///< names of earlier versions; a scene with one gets an error with the new name

  bool required = true;
  std::optional<ParameterValue> byDefault;
  std::optional<ParameterValue> byDefaultIn3D; ///< where it differs from 2D
  std::string derivedDefault;                  ///< text, where the default follows from other parameters

  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lowerOpen = false; ///< the bound itself is not allowed
  bool upperOpen = false;

  std::vector<std::string> choices;
  bool mayBeEmpty = true; ///< Text
  ArrayLength length;
  int onlyDimension = 0;   ///< 2 or 3: only scenes of this dimension have it; 0: all
  bool changeable = false; ///< may change when a run continues from a checkpoint
  /// TimeFunction: the parameter whose values it scales, if these are rates, such as velocities, so that its
  /// integral drives the run; else empty.
  std::string scalesRate;
  bool mayBeTable =
      false; ///< Real: a text may give it as a table of temperature (material/TemperatureTable.hpp)

  /// The default in a scene of this dimension; none if there is none.
  const ParameterValue* defaultIn(int dimension) const;
  bool existsIn(int dimension) const
  {
    return onlyDimension == 0 || dimension == 0 || onlyDimension == dimension;
  }
  /// The allowed values as text, such as "above -1 and below 0.5"; empty if all are.
  std::string rangeAsText() const;
};

/// Sets the attributes of one parameter. Valid until the section gets its next parameter.
class ParameterBuilder
{
public:
  explicit ParameterBuilder(Parameter& parameter) : p(&parameter) {}

  ParameterBuilder& unit(const std::string& u);
  /// A difference of temperatures, which is in K and in no unit with another zero.
  ParameterBuilder& temperatureDifference();
  ParameterBuilder& meaning(const std::string& m);
  /// The name that the parameter had in an earlier version.
  ParameterBuilder& formerly(const std::string& oldName);

  /// Must be given; this is the default.
  ParameterBuilder& required();
  /// Absent unless given.
  ParameterBuilder& optional();
  /// Absent unless given; the default, described by a text, follows from other parameters.
  ParameterBuilder& optional(const std::string& derivedDefault);
  ParameterBuilder& byDefault(double value); ///< also for integers
  ParameterBuilder& byDefault(int value);
  ParameterBuilder& byDefault(bool value);
  ParameterBuilder& byDefault(const char* value);
  ParameterBuilder& byDefault(const char* in2D, const char* in3D);
  ParameterBuilder& byDefault(std::vector<double> value);
  /// An array of zeros as long as `perAxis` or `perRotationAxis` ask.
  ParameterBuilder& byDefaultZeros();

  ParameterBuilder& atLeast(double bound);
  ParameterBuilder& above(double bound);
  ParameterBuilder& atMost(double bound);
  ParameterBuilder& below(double bound);
  ParameterBuilder& range(double lower, double upper) { return atLeast(lower).atMost(upper); }
  ParameterBuilder& positive() { return above(0.0); }
  ParameterBuilder& notNegative() { return atLeast(0.0); }

  ParameterBuilder& notEmpty();
  ParameterBuilder& length(int n);
  ParameterBuilder& multipleOf(int n, int fewest = 0);
  ParameterBuilder& perAxis();                      ///< D values
  ParameterBuilder& perPoint(int fewestPoints = 1); ///< points one after another, D values each
  ParameterBuilder& perRotationAxis();              ///< 1 value in 2D, 3 in 3D
  ParameterBuilder& onlyIn(int dimension);
  /// TimeFunction: \sa Parameter::scalesRate
  ParameterBuilder& scalesRate(const std::string& parameter);
  /// A run that continues from a checkpoint may have another value.
  ParameterBuilder& mayChange();
  /// A table of temperature is accepted instead of the number.
  ParameterBuilder& orTable();

private:
  Parameter* p;
};

/// A rule about which parameters of a section are given together.
struct Together
{
  enum class Rule
  {
    ExactlyOne,
    AtMostOne,
    AllOrNone
  };
  Rule rule;
  std::vector<std::string> names;
};

/// A parameter that may change when a run continues from a checkpoint (Parameter::changeable), but not in a
/// scene in which all conditions hold.
struct KeptParameter
{
  std::string section; ///< a top-level one that every such scene has
  std::string name;
  std::vector<Condition> conditions;
  std::string reason; ///< and what to do, as in a message after both values
};

struct Section
{
  enum class Presence
  {
    Optional, ///< absent unless given
    Required,
    Filled ///< added with its defaults where it is absent
  };

  std::string name;
  std::string meaning;
  std::vector<Parameter> parameters;
  std::vector<Section> sections; ///< subsections with fixed names
  Presence presence = Presence::Optional;
  int onlyDimension = 0;   ///< 2 or 3: only scenes of this dimension may have or choose it; 0: all
  bool changeable = false; ///< all its parameters may change when a run continues from a checkpoint
  std::vector<Together> together;

  /// The parameter that chooses one of `variants` by name; empty: there are none. The variant's parameters
  /// and subsections add to the section's own, in the same list.
  std::string key;
  std::vector<Section> variants;

  std::vector<Rule> rules; ///< combinations that are refused; only those of top-level sections are used
  std::vector<KeptParameter>
      kept; ///< that a restart must not change; only those of top-level sections are used
  std::vector<std::string> provides; ///< capabilities (scene/Compatibility.hpp)
  std::string namesOf; ///< section whose list names the user-named lists must have; empty: any name
  /// The parameter that names a material of the library, whose constants stand for parameters that a list
  /// does not have (scene/FillFromLibrary.hpp); empty: there is none.
  std::string libraryKey;
  /// Parameters of earlier versions, and where they are in the scene now.
  std::map<std::string, std::string> moved;

  /// Names of subsections that are planned.
  std::vector<std::string> toCome;

  /// Zero or one: the content of every user-named sublist, in addition to the fixed subsections. Its name is
  /// the kind of such a sublist, for example "body".
  std::vector<Section> entry;
  bool userNamed() const { return !entry.empty(); }

  Section(std::string name, std::string meaning);

  ParameterBuilder real(const std::string& parameter);
  ParameterBuilder integer(const std::string& parameter);
  ParameterBuilder boolean(const std::string& parameter);
  ParameterBuilder text(const std::string& parameter);
  ParameterBuilder choice(const std::string& parameter, std::vector<std::string> choices);
  ParameterBuilder realArray(const std::string& parameter);
  ParameterBuilder integerArray(const std::string& parameter);
  ParameterBuilder timeFunction(const std::string& parameter);

  /// Adds a subsection with a fixed name.
  Section& subsection(Section section);
  /// Every further sublist is named by the user and has the content of `section`.
  Section& namedByUser(Section section);
  /// Adds a parameter that names a material of the library, whose constants stand for absent parameters.
  ParameterBuilder fromLibrary(const std::string& parameter);
  /// Adds a parameter that chooses a variant. Add it before the variants.
  ParameterBuilder chosenBy(const std::string& parameter);
  Section& variant(Section section);

  Section& require();
  /// Added with its defaults where a scene lacks it.
  Section& fill();
  Section& onlyIn(int dimension);
  /// A run that continues from a checkpoint may have another such section, or none.
  Section& mayChange();
  Section& exactlyOneOf(std::vector<std::string> names);
  Section& atMostOneOf(std::vector<std::string> names);
  Section& allOrNoneOf(std::vector<std::string> names);

  /// A scene is refused where all conditions hold. \sa Rule
  Section& refuse(std::vector<Condition> conditions, const std::string& reason, int at = 0,
                  int onlyDimension = 0);
  /// A run that continues from a checkpoint must not change a parameter of another section where all
  /// conditions hold. \sa KeptParameter
  Section& keep(KeptParameter parameter);
  /// The section needs another one.
  Section& needs(const std::string& other, const std::string& reason);
  /// The section needs another one; its user-named lists must have the names of lists of that section.
  Section& namedAfter(const std::string& other, const std::string& reason);
  Section& provide(const std::string& capability);

  const Parameter* findParameter(const std::string& name) const;
  /// The parameter of the section, or of one of its variants, that had this name in an earlier version; or
  /// null.
  const Parameter* findFormer(const std::string& oldName) const;
  const Section* findSection(const std::string& name) const;
  const Section* findVariant(const std::string& name) const;

private:
  ParameterBuilder add(const std::string& parameter, ParameterType type);
};

/// A check of several parameters together; it adds the errors that it finds. It gets the sections of the core
/// and its own section, which is present, with defaults filled in and types normalised, but without invalid
/// entries: it must check that an entry exists. Combinations with other effects are checked by rules.
using CrossCheck = std::function<void(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)>;

/// The sections of the core and of the effects.
class SceneSchema
{
public:
  explicit SceneSchema(std::vector<Section> sections);

  /// The scene's top list as a section.
  const Section& root() const { return m_root; }
  /// Names of sections planned for a later version, for a clear error message.
  void setSectionsToCome(std::vector<std::string> names) { m_root.toCome = std::move(names); }

  /// A cross check of the core.
  void addCheck(CrossCheck check) { m_checks.push_back(std::move(check)); }
  const std::vector<CrossCheck>& checks() const { return m_checks; }
  /// The cross check of an effect, and its needs for the cells that Domain > Accuracy chooses.
  void addEffect(const std::string& section, CrossCheck check, CellHook hook)
  {
    m_effects[section] = {std::move(check), std::move(hook)};
  }
  /// By section.
  struct OfEffect
  {
    CrossCheck check;
    CellHook cells;
  };
  const std::map<std::string, OfEffect>& effects() const { return m_effects; }

private:
  Section m_root;
  std::vector<CrossCheck> m_checks;
  std::map<std::string, OfEffect> m_effects;
};

/// The sections of the material point method itself: Domain, Time, Materials, Bodies, Boundaries, Output,
/// Reference.
std::vector<Section> coreSections();

} // namespace Rhegma
