#include "energy_release/FrontSample.hpp"

#include "archive/Archive.hpp"
#include "material/StartOfGrowth.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace Rhegma::energy_release
{

namespace
{

template <int D>
double lengthOf(const CrackFront<D>& front)
{
  if constexpr (D == 3)
    return lineOf(front).length;
  else
    return front.nodes[0].tributaryLength;
}

/// The smallest or largest value of the nodes that have one.
template <class Better>
double extremeOf(const Along& values, const Better& better)
{
  double best = values.empty() ? 0.0 : FrontSample<3>::notYet;
  for (const double value : values)
    if (std::isfinite(value) && !(std::isfinite(best) && better(best, value)))
      best = value;
  return best;
}

/// Calls add(name, value) for a quantity: in 2D its value, in 3D its mean and extremes along the front.
template <int D, class Add>
void addQuantity(const char* name, const CrackFront<D>& front, const Along& values, const Add& add)
{
  add(name, meanAlong(front, values));
  if constexpr (D == 3)
  {
    add(std::string(name) + "_min", extremeOf(values, std::less<>{}));
    add(std::string(name) + "_max", extremeOf(values, std::greater<>{}));
  }
}

template <int D, class Add>
void addIntensities(const FrontSample<D>& s, const Add& add)
{
  addQuantity("K_I", s.front, s.modeI, add);
  addQuantity("K_II", s.front, s.modeII, add);
  if constexpr (D == 3)
    addQuantity("K_III", s.front, s.modeIII, add);
}

/// Angle [degrees], counter-clockwise, by which a front would turn; not known in anisotropic materials.
double kinkAngle(const FrontSample<2>& s)
{
  if (!s.isotropic)
    return FrontSample<2>::notYet;
  const double degrees = 45.0 / std::atan(1.0);
  const Vector<2>&along = s.front.direction, &normal = s.front.normal;
  const double turn = along[0] * normal[1] - along[1] * normal[0] > 0.0 ? degrees : -degrees;
  return turn * hoopStressAngle(s.modeI[0], s.modeII[0]);
}

void reportFront(const FrontSample<2>& s, const Options& options, nlohmann::json& entry)
{
  entry["position"] = {s.front.position[0], s.front.position[1]};
  entry["length"] = s.front.length;
  entry["speed"] = s.front.speed();
  if (!options.contour)
    return;
  entry["kink_angle"] = kinkAngle(s);
  entry["tip_offset"] = s.tipOffset;
}

nlohmann::json numbers(const Vector<3>& x) { return {x[0], x[1], x[2]}; }

void reportFront(const FrontSample<3>& s, const Options&, nlohmann::json& entry)
{
  nlohmann::json& nodes = entry["front_nodes"];
  nodes["G_J"] = s.J;
  nodes["K_I"] = s.modeI;
  nodes["K_II"] = s.modeII;
  nodes["K_III"] = s.modeIII;
  for (const char* name : {"position", "direction", "normal"})
    nodes[name] = nlohmann::json::array();
  const FrontLine line = lineOf(s.front);
  for (const FrontNode<3>& node : line.nodes)
  {
    nodes["position"].push_back(numbers(node.position));
    nodes["direction"].push_back(numbers(node.direction));
    nodes["normal"].push_back(numbers(node.normal));
  }
  nodes["arc_length"] = line.arc;
  nodes["line"] = line.line;
  entry["half_width"] = s.tube.halfWidth;
}

/// Saves or loads the nodes of a sampled front.
template <int D>
void storeNodes(std::vector<FrontNode<D>>& nodes, Archive& archive)
{
  constexpr int width = 3 + 3 * D; // facet, speed, tributary length, position, direction, normal
  std::vector<double> rows;
  for (const FrontNode<D>& node : nodes)
  {
    rows.insert(rows.end(), {node.facet >= 0 ? 0.0 : -1.0, node.speed, node.tributaryLength});
    for (const Vector<D>* v : {&node.position, &node.direction, &node.normal})
      rows.insert(rows.end(), v->c, v->c + D);
  }
  archive("nodes", rows, width);
  nodes.resize(rows.size() / width);
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    const double* row = &rows[width * k];
    nodes[k].facet = static_cast<int>(row[0]);
    nodes[k].speed = row[1];
    nodes[k].tributaryLength = row[2];
    std::copy_n(row + 3, D, nodes[k].position.c);
    std::copy_n(row + 3 + D, D, nodes[k].direction.c);
    std::copy_n(row + 3 + 2 * D, D, nodes[k].normal.c);
  }
}

} // namespace

template <int D>
double meanAlong(const CrackFront<D>& front, const Along& values)
{
  double sum = 0.0, length = lengthOf(front);
  std::size_t with = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::isfinite(values[k]))
    {
      sum += front.nodes[k].tributaryLength * values[k];
      ++with;
    }
    else
      length -= front.nodes[k].tributaryLength;
  if (with == 0 && !values.empty())
    return FrontSample<D>::notYet;
  return length > 0.0 ? sum / length : 0.0;
}

template <int D>
FrontSample<D>::FrontSample(const CrackFront<D>& of, double value)
    : front(of), J(of.nodes.size(), value), modeI(J), modeII(J), modeIII(J), tipOffset(value)
{
}

template <int D>
void FrontSample<D>::addTo(HistoryRow& row, const std::string& name, const Options& options) const
{
  const auto add = [&](const std::string& quantity, double value)
  { row.emplace_back(name + "." + quantity, value); };
  if (options.contour)
    addQuantity("G_J", front, J, add);
  if (closed && options.openingKnown)
    add("G_closure", closure.chosen);
  if (closed && options.lumped)
    add("G_closure_lumped", closure.lumped);
  if (options.contour)
    addIntensities(*this, add);
  add("length", front.length);
  add("speed", front.speed());
  for (int d = 0; d < D; ++d)
    add(std::string(1, "xyz"[d]), front.position[d]);
}

template <int D>
void FrontSample<D>::report(const Options& options, nlohmann::json& entry) const
{
  const auto add = [&](const std::string& quantity, double value) { entry[quantity] = value; };
  reportFront(*this, options, entry);
  if (closed && options.openingKnown)
    entry["G_closure"] = closure.chosen;
  if (closed && options.lumped)
    entry["G_closure_lumped"] = closure.lumped;
  if (!options.contour)
    return;
  addQuantity("G_J", front, J, add);
  addIntensities(*this, add);
  entry["closed"] = isClosed();
  entry["inner_radius"] = tube.radii.inner;
  entry["outer_radius"] = tube.radii.outer;
}

template <int D>
bool FrontSample<D>::isClosed() const
{
  constexpr double little = 0.01;
  const double K[3] = {meanAlong(front, modeI), meanAlong(front, modeII),
                       D == 3 ? meanAlong(front, modeIII) : 0.0};
  return K[0] < 0.0 && K[0] * K[0] > little * (K[0] * K[0] + K[1] * K[1] + K[2] * K[2]);
}

template <int D>
void FrontSample<D>::serialize(Archive& archive)
{
  archive("crack", front.crack);
  archive("number", front.number);
  archive("position", front.position);
  archive("direction", front.direction);
  archive("normal", front.normal);
  archive("length", front.length);
  archive("ended", front.ended);
  storeNodes(front.nodes, archive);
  tube.store("tube", archive);
  archive("J", J);
  archive("K_I", modeI);
  archive("K_II", modeII);
  archive("K_III", modeIII);
  archive("tip_offset", tipOffset);
  archive("isotropic", isotropic);
  archive("closed", closed);
  archive("closure", closure.chosen);
  archive("closure_lumped", closure.lumped);
}

template double meanAlong(const CrackFront<2>&, const Along&);
template double meanAlong(const CrackFront<3>&, const Along&);
template struct FrontSample<2>;
template struct FrontSample<3>;

} // namespace Rhegma::energy_release
