#include "thermal/CrackConduction.hpp"

#include "archive/Archive.hpp"
#include "base/ReadList.hpp"
#include "material/Tensors.hpp"
#include "state/OpeningFraction.hpp"
#include "state/Subdomain.hpp"
#include "transfer/PushNodes.hpp"
#include "transfer/Stencils.hpp"

#include <cmath>

namespace Rhegma::thermal
{

namespace
{

/// Faces less than this fraction of a cell apart are closed: round-off does not open them.
constexpr double closedGap = 1e-6;

/// Adds volume times slope of the functions of enriched fields.
template <int D>
struct EndsBlock
{
  View<double * [D + 2]> faces;
  View<int*> row;
  StencilTable<D> table;
  BorrowedView<double*> volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  int numLattice;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      const int r = row(p);
      if (r < 0)
        continue;
      const double now = determinant<D>(&deformation(p, 0)) * volume(p);
      for (int k = 0; k < table.count(r); ++k)
        if (table.node(r, k) >= numLattice)
          for (int d = 0; d < D; ++d)
            faces(table.node(r, k), 2 + d) += now * table.slope(r, k, d);
    }
  }
};

/// Adds volume, and volume times conductivity, of the particles near cracks to their nodes: of those on an
/// enriched field these are all. That of a material with axes is the mean that a circle of flux sees.
template <int D>
struct ConductivityBlock
{
  View<double* [2]> around;
  View<int*> row;
  StencilTable<D> table;
  ThermoTables thermo;
  BorrowedView<double*> volume, temperature;
  BorrowedView<int*> material;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      const int r = row(p);
      if (r < 0)
        continue;
      double conductivity = ThermoPoint(thermo, material(p), temperature(p)).conductivity();
      if constexpr (D == 2)
        conductivity *=
            std::sqrt(thermo.material(material(p)).ratio[0] * thermo.material(material(p)).ratio[1]);
      for (int k = 0; k < table.count(r); ++k)
      {
        const double part = table.weight(r, k) * volume(p);
        around(table.node(r, k), 0) += part;
        around(table.node(r, k), 1) += part * conductivity;
      }
    }
  }
};

} // namespace

template <int D>
void CrackConduction<D>::read(const Teuchos::ParameterList& list, const State<D>& state)
{
  const std::size_t count = state.cracks.cracks.size();
  laws_ = View<FaceLaw*>("rhegma::thermal::faceLaws", count);
  const auto host = Kokkos::create_mirror_view(laws_);
  for (std::size_t c = 0; c < count; ++c)
  {
    host(c) = FaceLaw{};
    const std::string& name = state.cracks.cracks[c].name;
    if (!list.isSublist(name))
      continue;
    const Teuchos::ParameterList& faces = list.sublist(name);
    const std::string kind = faces.get<std::string>("Conduction");
    if (kind == "Insulating")
      continue;
    host(c).conductance =
        faces.isParameter("Conductance") ? faces.get<double>("Conductance") : double(perfect);
    host(c).onlyWhereClosed = kind == "When Closed";
    conducts_ = true;
    perfectContact_ = perfectContact_ || host(c).conductance == perfect;
  }
  Kokkos::deep_copy(laws_, host);
}

template <int D>
std::vector<char> CrackConduction<D>::insulating() const
{
  const auto laws = onHost(laws_);
  std::vector<char> all(laws.extent(0));
  for (std::size_t c = 0; c < all.size(); ++c)
    all[c] = laws(c).conductance > 0.0 ? 0 : 1;
  return all;
}

template <int D>
void CrackConduction<D>::update(const State<D>& state, const HeatNodes<D>& nodes)
{
  const bool atFronts = state.cracks.frontConductance.extent(0) > 0;
  if ((!conducts_ && !atFronts) || state.cracks.simplex.extent(0) == 0 ||
      state.cracks.enrichedField.extent(0) == 0)
    return;
  const std::size_t rows = state.mesh.nodes.sums.extent(0);
  if (conductance_.extent(0) < rows)
    conductance_ = View<double*>("rhegma::thermal::conductance", rows);
  if (conducts_)
    ofFaces(state);
  if (atFronts)
    ofFronts(state, nodes);
}

/// Conductance of nodes whose fields pass heat through faces.
template <int D>
void CrackConduction<D>::ofFaces(const State<D>& state)
{
  points_.update(state);
  searchAround(state);
  if (faces_.extent(0) < conductance_.extent(0))
    faces_ = View<double * [D + 2]>("rhegma::thermal::faces", conductance_.extent(0));
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double * [D + 2]> faces = faces_;
  Kokkos::parallel_for(
      "rhegma::thermal::clearFaces", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < D + 2; ++k)
          faces(activeNode(nodes, i), k) = 0.0;
      });
  addFaces(state);
  const FieldTable& table = state.particles;
  const EndsBlock<D> block{faces_,
                           state.stored.row,
                           state.stored.table,
                           table.scalar(fields::volume),
                           table.real<gradientSize<D>>(fields::deformation),
                           state.mesh.nodes.numLattice};
  if (state.stored.count > 0)
    forEachBlock("rhegma::thermal::endsOfFields", state.mesh.blocks, block);
  sumOverRanks(state, faces_.data(), D + 2, 0, D + 2);
  findConductance(state);
}

/// Conductance of nodes that are not cut in full, in addition to that of faces.
template <int D>
void CrackConduction<D>::ofFronts(const State<D>& state, const HeatNodes<D>& heat)
{
  const Nodes<D> nodes = state.mesh.nodes;
  if (aroundNode_.extent(0) < conductance_.extent(0))
    aroundNode_ = View<double* [2]>("rhegma::thermal::conductivityAroundNode", conductance_.extent(0));
  const View<double* [2]> around = aroundNode_;
  Kokkos::parallel_for(
      "rhegma::thermal::clearConductivity", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        around(n, 0) = around(n, 1) = 0.0;
      });
  const FieldTable& table = state.particles;
  const ConductivityBlock<D> block{around,
                                   state.stored.row,
                                   state.stored.table,
                                   state.materials.thermo,
                                   table.scalar(fields::volume),
                                   table.scalar(fields::temperature),
                                   table.integer(fields::material)};
  if (state.stored.count > 0)
    forEachBlock("rhegma::thermal::conductivityAtFronts", state.mesh.blocks, block);
  sumOverRanks(state, around.data(), 2, 0, 2);
  const View<double*> ofFront = state.cracks.frontConductance, conductance = conductance_;
  const double thickness = state.method.thickness, spacing = state.mesh.grid.spacing;
  const View<int*> level = state.mesh.tree.nodeLevel;
  const bool faces = conducts_, refined = state.mesh.tree.refined();
  Kokkos::parallel_for(
      "rhegma::thermal::conductanceAtFronts", Kokkos::RangePolicy<ExecSpace>(0, nodes.numOfCracks),
      KOKKOS_LAMBDA(const int i) {
        const int one = nodes.parent(i);
        const double C1 = heat.sums(one, HeatNodes<D>::capacityAt);
        const double C2 = heat.sums(nodes.numLattice + i, HeatNodes<D>::capacityAt);
        const int two = nodes.numLattice + i;
        const double volume = around(one, 0) + around(two, 0);
        const double k = volume > 0.0 ? (around(one, 1) + around(two, 1)) / volume : 0.0;
        // In 3D the filled part of a cell.
        const double cell = refined ? spacing / (1 << level(one)) : spacing;
        const double width = D == 2 ? thickness : std::fmin(volume / (cell * cell), cell);
        const double here = C1 > 0.0 && C2 > 0.0 ? k * width * openingFraction(C1, C2) * ofFront(one) : 0.0;
        conductance(one) = here + (faces ? conductance(one) : 0.0);
      });
}

/// Stencils at both sides of the face points.
template <int D>
void CrackConduction<D>::searchAround(const State<D>& state)
{
  const int count = points_.count();
  if (around_.count != 2 * count)
  {
    around_.count = 2 * count;
    around_.onAllRanks = true;
    around_.position = View<double* [D]>("rhegma::thermal::aroundFace", 2 * count);
    around_.half = View<double* [D]>("rhegma::thermal::aroundFaceHalf", 2 * count);
    around_.side = View<int*>("rhegma::thermal::aroundFaceSide", 2 * count); // 0: as if there were no crack
  }
  const FacePoints<D> points = points_;
  const View<double* [D]> position = around_.position;
  const double reach = 0.5 * state.mesh.smallestSpacing();
  const View<double* [D]> normal = state.cracks.normal; // in the cells
  const View<int*> simplex = points_.simplex();
  Kokkos::parallel_for(
      "rhegma::thermal::lookAroundFaces", Kokkos::RangePolicy<ExecSpace>(0, count),
      KOKKOS_LAMBDA(const int k) {
        for (int d = 0; d < D; ++d)
        {
          position(2 * k, d) = points.position(k, d) - reach * normal(simplex(k), d);
          position(2 * k + 1, d) = points.position(k, d) + reach * normal(simplex(k), d);
        }
      });
  pointStencils(state, around_, stencils_, false);
}

template <int D>
void CrackConduction<D>::addFaces(const State<D>& state)
{
  const FacePoints<D> points = points_;
  const StencilTable<D> stencils = stencils_;
  const View<FaceLaw*> laws = laws_;
  const View<double * [D + 2]> faces = faces_;
  const View<double* [D]> normal = state.cracks.normal;
  const View<int*> simplex = points_.simplex();
  const double gap = closedGap * state.mesh.smallestSpacing();
  forEachPushing(
      "rhegma::thermal::facesAroundNodes", 2 * points_.count(), KOKKOS_LAMBDA(const int s) {
        const int k = s / 2;
        const FaceLaw law = laws(points.crack(k));
        const bool passes = !law.onlyWhereClosed || points.separation(k) <= gap;
        for (int e = 0; e < stencils.count(s); ++e)
        {
          const int n = stencils.node(s, e);
          const double area = stencils.weight(s, e) * points.currentSize(k);
          Kokkos::atomic_add(&faces(n, 0), passes ? area * law.conductance : 0.0);
          Kokkos::atomic_add(&faces(n, 1), area);
          for (int d = 0; d < D; ++d)
            Kokkos::atomic_add(&faces(n, 2 + d), area * normal(simplex(k), d));
        }
      });
}

template <int D>
void CrackConduction<D>::findConductance(const State<D>& state)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double * [D + 2]> faces = faces_;
  const View<double*> conductance = conductance_;
  Kokkos::parallel_for(
      "rhegma::thermal::findConductance", Kokkos::RangePolicy<ExecSpace>(0, nodes.numOfCracks),
      KOKKOS_LAMBDA(const int i) {
        const int two = nodes.numLattice + i, one = nodes.parent(i);
        double along = 0.0, square = 0.0;
        for (int d = 0; d < D; ++d)
        {
          along += faces(one, 2 + d) * faces(two, 2 + d);
          square += faces(one, 2 + d) * faces(one, 2 + d);
        }
        // The enriched field of a node on side +1 belongs to the material of side -1, which ends there along
        // the normal.
        const double area = (side(one) > 0 ? along : -along) / std::sqrt(square);
        conductance(one) =
            faces(one, 1) > 0.0 && square > 0.0 && area > 0.0 ? area * faces(one, 0) / faces(one, 1) : 0.0;
      });
}

template <int D>
void CrackConduction<D>::merge(const State<D>& state, const HeatNodes<D>& heat, double fraction) const
{
  if (!perfectContact_ || !active(state))
    return;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double * [D + 2]> faces = faces_;
  const View<double*> conductance = conductance_;
  const bool several = heat.meets.extent(0) > 0;
  Kokkos::parallel_for(
      "rhegma::thermal::mergeFields", Kokkos::RangePolicy<ExecSpace>(0, nodes.numOfCracks),
      KOKKOS_LAMBDA(const int i) {
        const int two = nodes.numLattice + i, one = nodes.parent(i);
        const double C1 = heat.sums(one, HeatNodes<D>::capacityAt);
        const double C2 = heat.sums(two, HeatNodes<D>::capacityAt);
        // Perfect contact dominates the mean around the node.
        if (!(conductance(one) > 0.0) || !(faces(one, 0) > 1e-6 * perfect * faces(one, 1)) || !(C1 > 0.0) ||
            !(C2 > 0.0) || heat.insulates(one) || heat.insulates(two))
          return;
        const double T = (C1 * heat.value(one, 0) + C2 * heat.value(two, 0)) / (C1 + C2);
        heat.value(one, 0) = heat.value(one, 2) = heat.value(two, 0) = heat.value(two, 2) = T;
        if (!several)
          return;
        for (int k = 0; k < HeatNodes<D>::joinAt; ++k)
          heat.meets(one, k) = heat.meets(two, k) = heat.meets(one, k) + heat.meets(two, k);
        heat.meets(one, HeatNodes<D>::joinAt) = heat.meets(two, HeatNodes<D>::joinAt) =
            heat.severalAt(one) ? fraction : 0.0;
      });
}

template <int D>
double CrackConduction<D>::exchange(const State<D>& state, const HeatNodes<D>& heat, double dt) const
{
  if (!active(state))
    return 0.0;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*> conductance = conductance_;
  double fromOutside = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::exchangeBetweenFaces", Kokkos::RangePolicy<ExecSpace>(0, nodes.numOfCracks),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int two = nodes.numLattice + i, one = nodes.parent(i);
        const double C1 = heat.sums(one, HeatNodes<D>::capacityAt);
        const double C2 = heat.sums(two, HeatNodes<D>::capacityAt);
        if (!(conductance(one) > 0.0) || !(C1 > 0.0) || !(C2 > 0.0) || heat.insulates(one) ||
            heat.insulates(two))
          return;
        const bool held1 = heat.held(one) != 0, held2 = heat.held(two) != 0;
        // A prescribed value is the temperature at the end of the step and is not changed by heat.
        const double T1 = heat.value(one, 0) + (held1 ? 0.0 : heat.value(one, 1));
        const double T2 = heat.value(two, 0) + (held2 ? 0.0 : heat.value(two, 1));
        const double passed =
            (T1 - T2) / (1.0 / (dt * conductance(one)) + (held1 ? 0.0 : 1.0 / C1) + (held2 ? 0.0 : 1.0 / C2));
        const bool counts = isOwnedByThisRank(nodes, one);
        if (!held1)
          heat.value(one, 1) -= passed / C1;
        else if (counts)
          sum += passed;
        if (!held2)
          heat.value(two, 1) += passed / C2;
        else if (counts)
          sum -= passed;
      },
      fromOutside);
  return fromOutside;
}

template <int D>
void CrackConduction<D>::serialize(Archive& archive)
{
  points_.serialize(archive);
}

template class CrackConduction<2>;
template class CrackConduction<3>;

} // namespace Rhegma::thermal
