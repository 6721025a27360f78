#include "cohesive_faces/CohesiveReport.hpp"

namespace Rhegma::cohesive_faces
{

template <int D>
void sampleCohesion(State<D>& state, const FaceCohesion<D>& cohesion, const std::vector<TractionLaw>& laws)
{
  HistoryRow& row = state.sample.row;
  for (std::size_t c = 0; c < laws.size(); ++c)
  {
    if (!laws[c].holds)
      continue;
    const CohesionSums<D> sums = cohesion.sumsOf(static_cast<int>(c));
    const std::string name = state.cracks.cracks[c].name + ".cohesive_";
    row.emplace_back(name + "damaged", sums.damaged);
    row.emplace_back(name + "failed", sums.failed);
    row.emplace_back(name + "opening", cohesion.records()[c].largestOpening);
    row.emplace_back(name + "slip", cohesion.records()[c].largestSlip);
    row.emplace_back(name + "stored", sums.stored);
    row.emplace_back(name + "dissipated_I", sums.lost[0]);
    row.emplace_back(name + "dissipated_II", sums.lost[1]);
  }
}

template <int D>
void reportCohesion(const FaceCohesion<D>& cohesion, const std::vector<TractionLaw>& laws,
                    nlohmann::json& summary)
{
  for (std::size_t c = 0; c < laws.size(); ++c)
  {
    if (!laws[c].holds)
      continue;
    const CohesionSums<D> sums = cohesion.sumsOf(static_cast<int>(c));
    const CohesionRecord<D>& record = cohesion.records()[c];
    const auto positionOf = [](const Vector<D>& x) { return std::vector<double>(x.c, x.c + D); };
    nlohmann::json& entry = summary["cracks"][c]["cohesive"];
    entry["bonded"] = sums.bonded;
    entry["damaged"] = sums.damaged;
    entry["failed"] = sums.failed;
    const bool begun = record.initiated >= 0.0;
    entry["initiated"] = begun ? nlohmann::json(record.initiated) : nlohmann::json();
    entry["initiated_at"] = begun ? nlohmann::json(positionOf(record.first)) : nlohmann::json();
    entry["failed_to"] = sums.failed > 0.0 ? nlohmann::json(positionOf(sums.reach)) : nlohmann::json();
    entry["largest_opening"] = record.largestOpening;
    entry["largest_slip"] = record.largestSlip;
    entry["stored"] = sums.stored;
    entry["dissipated_I"] = sums.lost[0];
    entry["dissipated_II"] = sums.lost[1];
    entry["initial_stiffness"] = laws[c].normal;
    entry["initial_shear_stiffness"] = laws[c].shear;
  }
}

template void sampleCohesion(State<2>&, const FaceCohesion<2>&, const std::vector<TractionLaw>&);
template void sampleCohesion(State<3>&, const FaceCohesion<3>&, const std::vector<TractionLaw>&);
template void reportCohesion(const FaceCohesion<2>&, const std::vector<TractionLaw>&, nlohmann::json&);
template void reportCohesion(const FaceCohesion<3>&, const std::vector<TractionLaw>&, nlohmann::json&);

} // namespace Rhegma::cohesive_faces
