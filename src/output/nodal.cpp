#include "output/nodal.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "assembly/vectors.hpp"
#include "contact/mortar/facet_frame.hpp"
#include "output/point_fields.hpp"

namespace mortise {
namespace {

/// A value per component and node.
using NodalField = std::vector<std::vector<double>>;

std::vector<double> at_secondary_nodes(const StepProblem& problem, const std::vector<double>& unknowns) {
  const int n = problem.dofs().n_nodes();
  std::vector<double> values(n, 0.0);
  for (const ContactNodes* contact : problem.scene().contacts_with_pressures())
    for (std::size_t k = 0; k < contact->secondary_nodes.size(); ++k)
      values[contact->secondary_nodes[k]] = unknowns[problem.dofs().global(n + contact->first_multiplier + static_cast<int>(k))];
  return values;
}

NodalField tractions(const StepProblem& problem, const std::vector<double>& unknowns) {
  const int n = problem.dofs().n_nodes();
  NodalField field(3, std::vector<double>(n, 0.0));
  for (const ContactPair& pair : problem.scene().pairs) {
    if (!pair.friction) continue;
    for (std::size_t k = 0; k < pair.secondary_nodes.size(); ++k) {
      const GlobalIndex at = problem.dofs().global(n + pair.first_multiplier + static_cast<int>(k));
      for (int i = 0; i < 3; ++i) field[i][pair.secondary_nodes[k]] = unknowns[at + 1 + i];
    }
  }
  return field;
}

// Tractions of ties turned with their facets: the mean of what the facets round a node make of it.
NodalField tie_tractions(const StepProblem& problem, const std::vector<double>& unknowns) {
  const int n = problem.dofs().n_nodes();
  NodalField field(3, std::vector<double>(n, 0.0));
  const auto& X = problem.scene().mesh.mesh.coordinates;
  for (const Tie& tie : problem.scene().ties) {
    std::map<int, int> n_facets;
    for (const TieFacet& facet : tie.facets)
      for (int node : tie.secondary.facets[facet.index]) ++n_facets[node];
    for (const TieFacet& facet : tie.facets) {
      std::array<Vec3<double>, 4> reference, current;
      const auto& nodes = tie.secondary.facets[facet.index];
      for (int a = 0; a < 4; ++a) {
        const double* q = &unknowns[3 * static_cast<std::size_t>(nodes[a])];
        reference[a] = vec3(X[nodes[a]]);
        current[a] = tie.form == TieForm::plain ? reference[a] : Vec3<double>{q[0], q[1], q[2]};
      }
      const auto R = facet_rotation(current, facet_frame(reference));
      for (int node : nodes) {
        const auto k =
            std::lower_bound(tie.secondary_nodes.begin(), tie.secondary_nodes.end(), node) - tie.secondary_nodes.begin();
        const double* on_body = &unknowns[problem.dofs().global(n + tie.first_multiplier + static_cast<int>(k))];
        for (int i = 0; i < 3; ++i)
          field[i][node] -= (R(i, 0) * on_body[0] + R(i, 1) * on_body[1] + R(i, 2) * on_body[2]) / n_facets[node];
      }
    }
  }
  return field;
}

std::vector<double> contact_status(const StepProblem& problem, const Evaluation& at) {
  std::vector<double> values(problem.dofs().n_nodes(), 0.0);
  for (const ContactNodes* contact : problem.scene().contacts_with_pressures())
    for (std::size_t k = 0; k < contact->secondary_nodes.size(); ++k) {
      const std::size_t multiplier = contact->first_multiplier + k;
      const bool sticks = !at.friction.empty() && at.friction[multiplier] == FrictionStatus::stick;
      values[contact->secondary_nodes[k]] = at.closed[multiplier] + (sticks ? 1 : 0);
    }
  return values;
}

NodalField by_axis(const std::vector<double>& unknowns, int n) {
  NodalField field(3, std::vector<double>(n));
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i) field[i][a] = unknowns[3 * static_cast<std::size_t>(a) + i];
  return field;
}

NodalField displacement(const StepProblem& problem, const State& state) {
  const auto& X = problem.scene().mesh.mesh.coordinates;
  NodalField u = by_axis(problem.gather(*state.x), problem.dofs().n_nodes());
  for (std::size_t a = 0; a < X.size(); ++a)
    for (int i = 0; i < 3; ++i) u[i][a] -= X[a][i];
  return u;
}

NodalField reaction(const StepProblem& problem, const Evaluation& at) {
  const int n = problem.dofs().n_nodes();
  const auto unbalanced = problem.gather(*at.unbalanced);
  NodalField field(3, std::vector<double>(n, 0.0));
  for (const auto& p : *at.prescribed) field[p.axis][p.node] = unbalanced[3 * static_cast<std::size_t>(p.node) + p.axis];
  return field;
}

/// A field that has values at nodes without an average.
NodalField field_of_nodes(const StepProblem& problem, const State& state, const Evaluation& at, Field field) {
  const int n = problem.dofs().n_nodes();
  switch (field) {
    case Field::displacement:
      return displacement(problem, state);
    case Field::position:
      return by_axis(problem.gather(*state.x), n);
    case Field::reaction:
      return reaction(problem, at);
    case Field::contact_pressure:
      return {at_secondary_nodes(problem, problem.gather(*state.x))};
    case Field::gap:
      if (problem.scene().n_multipliers == 0) return {std::vector<double>(n, 0.0)};
      return {at_secondary_nodes(problem, problem.gather(*at.gap))};
    case Field::tangential_traction:
      return tractions(problem, problem.gather(*state.x));
    case Field::tie_traction:
      return tie_tractions(problem, problem.gather(*state.x));
    case Field::status:
      return {contact_status(problem, at)};
    default: {  // of motion: all rests in a static stage; a run of statics alone, which the deck reader refuses, has none
      if (!problem.scene().has_inertia())
        throw std::logic_error(std::string("no field \"") + entry_of(field).name + "\" in statics");
      const RCP<Vector>& rate = field == Field::velocity ? state.v : state.a;
      return rate.is_null() ? NodalField(3, std::vector<double>(n, 0.0)) : by_axis(problem.gather(*rate), n);
    }
  }
}

/// Means at the nodes of several fields of quadrature points.
std::vector<NodalField> means_at_nodes(const StepProblem& problem, const State& state, const std::vector<Field>& fields) {
  std::size_t width = 1;  // the sum of weights comes first, then the weighted components of all fields
  std::vector<std::size_t> first, count;
  for (Field field : fields) {
    first.push_back(width);
    count.push_back(suffixes(entry_of(field).shape).size());
    width += count.back();
  }
  const std::size_t n = static_cast<std::size_t>(problem.dofs().n_nodes());
  std::vector<double> sums(width * n, 0.0), values(width, 1.0);
  const auto x = problem.to_overlap(*state.x);
  for (const auto& body : problem.bodies())
    body->sample(data(*x), [&](const PointSample& at) {
      for (std::size_t f = 0; f < fields.size(); ++f) {
        const FieldValues field = values_at_point(fields[f], at.state);
        std::copy_n(field.begin(), count[f], values.begin() + static_cast<long>(first[f]));
      }
      for (int a = 0; a < at.n_nodes; ++a) {
        const double weight = std::max(at.N[a], 0.0) * at.JxW;
        double* sum = &sums[width * static_cast<std::size_t>(at.nodes[a])];
        for (std::size_t k = 0; k < width; ++k) sum[k] += weight * values[k];
      }
    });
  all_reduce(*problem.dofs().comm(), Teuchos::REDUCE_SUM, sums);
  std::vector<NodalField> means;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    NodalField mean(count[f], std::vector<double>(n, 0.0));
    for (std::size_t a = 0; a < n; ++a)
      if (const double weight = sums[width * a]; weight > 0)  // a node that no element has keeps 0
        for (std::size_t c = 0; c < count[f]; ++c) mean[c][a] = sums[width * a + first[f] + c] / weight;
    means.push_back(std::move(mean));
  }
  return means;
}

NodalField from_mean(Field field, const NodalField& mean) {
  NodalField values(suffixes(entry_of(field).shape).size(), std::vector<double>(mean[0].size()));
  for (std::size_t a = 0; a < mean[0].size(); ++a) {
    FieldValues at{};
    for (std::size_t c = 0; c < mean.size(); ++c) at[c] = mean[c][a];
    const FieldValues found = values_of_mean(field, at);
    for (std::size_t c = 0; c < values.size(); ++c) values[c][a] = found[c];
  }
  return values;
}

}  // namespace

std::vector<std::vector<double>> nodal_variables(const StepProblem& problem, const State& state, const Evaluation& at,
                                                 const std::vector<std::string>& names) {
  std::vector<FieldComponent> components;
  std::map<Field, NodalField> fields, means;
  for (const std::string& name : names) {
    components.push_back(component_named(name));
    const Field field = components.back().field;
    fields[field];
    if (entry_of(field).place == FieldPlace::point) means[averaged_field(field)];
  }
  if (!means.empty()) {
    std::vector<Field> averaged;
    for (const auto& mean : means) averaged.push_back(mean.first);
    std::vector<NodalField> found = means_at_nodes(problem, state, averaged);
    for (std::size_t f = 0; f < averaged.size(); ++f) means[averaged[f]] = std::move(found[f]);
  }
  for (auto& [field, values] : fields)
    values = entry_of(field).place == FieldPlace::point ? from_mean(field, means[averaged_field(field)])
                                                        : field_of_nodes(problem, state, at, field);
  std::vector<std::vector<double>> variables;
  for (const FieldComponent& one : components) variables.push_back(fields[one.field][one.component]);
  return variables;
}

}  // namespace mortise
