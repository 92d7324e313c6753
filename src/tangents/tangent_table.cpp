#include "tangents/tangent_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mortise {
namespace {

double unit_of_time(const CheckedTerm& term, const StateResult& at) {
  for (std::size_t w = 0; w < term.ways.size(); ++w)
    if (term.ways[w].kind == term.time_unit) return at.ways[w].seconds;
  return 0;
}

std::string name_of(const CheckedTerm& term, TangentKind kind) {
  return std::find_if(term.ways.begin(), term.ways.end(), [kind](const Way& way) { return way.kind == kind; })->name;
}

std::string difference(const CheckedTerm& term, const Way& way, const WayResult& found, const StateResult& at) {
  if (way.kind == term.reference || found.farthest < 0 || at.n_pieces == 0) return "-";
  return fmt::format("{:.1e}", found.difference);
}

std::string order(const Way& way, const WayResult& found) {
  if (expected_order(way.kind) == 0) return "-";
  return found.order ? fmt::format("{:.2f}", *found.order) : "exact";
}

/// A cell in quotes, which are doubled inside.
std::string quoted(const std::string& text) {
  std::string cell = "\"";
  for (char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + '"';
}

}  // namespace

std::string table(const TermResult& result) {
  const CheckedTerm& term = *result.term;
  std::string text = fmt::format("{}: {} of {} {}\n", term.name, term.n_chosen, term.n_pieces, term.pieces_name);
  for (std::size_t s = 0; s < checked_states.size(); ++s) {
    const StateResult& at = result.at[s];
    if (!term.has_kinks) continue;
    text +=
        fmt::format("  {} state: {} pairs of facets overlap by 1 % and more, at {} of them a kink is too near for differences\n",
                    checked_states[s], at.n_pieces, at.n_kinks);
  }
  text += fmt::format("  {:<22}{:>12}{:>8}{:>12}{:>8}{:>12}{:>9}\n", "", "initial:", "", "deformed:", "", "time", "over");
  text += fmt::format("  {:<22}{:>12}{:>8}{:>12}{:>8}{:>12}  {}\n", "way", "difference", "order", "difference", "order", "[us]",
                      name_of(term, term.time_unit));
  for (std::size_t w = 0; w < term.ways.size(); ++w) {
    const Way& way = term.ways[w];
    const WayResult &first = result.at[0].ways[w], &second = result.at[1].ways[w];
    const double unit = unit_of_time(term, result.at[1]);
    text += fmt::format("  {:<22}{:>12}{:>8}{:>12}{:>8}{:>12.2f}{:>9}\n", way.name, difference(term, way, first, result.at[0]),
                        order(way, first), difference(term, way, second, result.at[1]), order(way, second), 1e6 * second.seconds,
                        unit > 0 ? fmt::format("{:.2f}", second.seconds / unit) : "-");
  }
  return text;
}

std::string table(const std::vector<StepTangent>& steps) {
  std::string text = "tangents of whole steps at the deformed state, against central differences\n";
  for (const StepTangent& step : steps)
    text +=
        fmt::format("  {}: {:.1e}, {} rows along {} directions\n", step.name, step.difference, step.n_rows, n_step_directions);
  return text;
}

std::string csv(const std::vector<TermResult>& results, const std::vector<StepTangent>& steps) {
  std::string text = "term,state,way,chosen,compared,kinks,difference,order,orders,seconds,relative_time\n";
  for (const TermResult& result : results)
    for (std::size_t s = 0; s < checked_states.size(); ++s)
      for (std::size_t w = 0; w < result.term->ways.size(); ++w) {
        const StateResult& at = result.at[s];
        const WayResult& way = at.ways[w];
        const double unit = unit_of_time(*result.term, at);
        text += fmt::format("{},{},{},{},{},{},{:.6e},{},{},{:.6e},{:.6g}\n", quoted(result.term->name), checked_states[s],
                            result.term->ways[w].name, result.term->n_chosen, at.n_pieces, at.n_kinks, way.difference,
                            way.order ? fmt::format("{:.6f}", *way.order) : "", way.n_orders, way.seconds,
                            unit > 0 ? way.seconds / unit : 0.0);
      }
  for (const StepTangent& step : steps)
    text +=
        fmt::format("{},deformed,whole step,{},{},0,{:.6e},,0,,\n", quoted(step.name), step.n_rows, step.n_rows, step.difference);
  return text;
}

}  // namespace mortise
