#pragma once
/// Which bodies a crack of the scene cuts.

#include "cracks/ReadCrack.hpp"

#include <memory>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

/// A crack may end this far inside of bodies that it does not cut: its end sticks out of its own body
/// [cells].
constexpr double mostOverhang = 2.0;

/// The bodies of a scene, and where an effect keeps bodies apart that are not bonded, the groups of them.
template <int D>
class CrackedBodies
{
public:
  /// \param scene validated \param keptApart whether bodies that are not bonded are kept apart
  CrackedBodies(const Teuchos::ParameterList& scene, bool keptApart);

  /// The shapes of a group, or all for 0. \param bodyGroup as Crack::bodyGroup
  const SceneBodies<D>& of(int bodyGroup) const
  {
    return bodyGroup == 0 ? all_ : groups_[bodyGroup - 1].shapes;
  }

  /// Whether there are groups that are kept apart.
  bool areKeptApart() const { return !groups_.empty(); }

  /// Where each group is, or where all bodies are if they are not kept apart.
  using Regions = std::vector<std::unique_ptr<BodyRegion<D>>>;
  /// \param state with the particles
  Regions regions(const State<D>& state) const;

  /// Reads one crack, cut to the bodies of its group: the one of which it cuts most.
  ///
  /// \param list, where, warnings as for readCrack \param regions of these bodies \param state, edge, front
  /// as in ReadingContext
  /// \param bodyGroup becomes that of the crack
  ///
  /// \throws std::invalid_argument as readCrack, and for a crack that reaches more than mostOverhang into a
  /// second group
  surface::CrackMesh<D> read(const Teuchos::ParameterList& list, const std::string& where,
                             const Regions& regions, const State<D>& state, double edge, double front,
                             std::vector<std::string>& warnings, int& bodyGroup) const;

private:
  struct Group
  {
    std::string name;        ///< its bodies
    std::vector<bool> holds; ///< whether it holds each body
    SceneBodies<D> shapes;
  };

  SceneBodies<D> all_;
  std::vector<Group> groups_;
};

} // namespace Rhegma::cracks
