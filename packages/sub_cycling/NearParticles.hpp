#pragma once
/// Particles that may take part in substeps.

#include "state/State.hpp"

#include <string>

namespace Rhegma::sub_cycling
{

/// Capacity for some more than asked for; values are lost when a view grows.
template <class AnyView>
void fit(AnyView& view, const std::string& label, int size)
{
  if (static_cast<int>(view.extent(0)) < size)
    view = AnyView(label, size + size / 4);
}

/// The particles in cells of the lattice that are not far from refined ones.
template <int D>
class NearParticles
{
public:
  /// Finds them as particles and cells are now.
  void find(const State<D>& state);

  int count() const { return count_; }
  const View<int*>& particles() const { return particle_; }

  // Public because compilers for devices want kernels in public functions.

  /// Particles of blocks that have such cells or whose particles can reach them, until the next sort.
  void findInBlocks(const State<D>& state);

private:
  int generation_ = -1; ///< of the tree, when
  View<char*> near_;    ///< not 0 for cells of the lattice that are not far from refined ones
  View<int*> sorted_;   ///< the first particles of blocks, when the list that follows was made
  View<int*> inBlocks_; ///< see findInBlocks
  int numInBlocks_ = 0, count_ = 0;
  View<int*> particle_;
};

} // namespace Rhegma::sub_cycling
