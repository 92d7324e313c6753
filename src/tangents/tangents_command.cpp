// `mortise tangents`: checks the tangents of a scene, or studies numerical differentiation.
#include <fmt/format.h>

#include <iostream>

#include "assembly/vectors.hpp"
#include "commands.hpp"
#include "output/atomic_file.hpp"
#include "output/on_root.hpp"
#include "setup.hpp"
#include "tangents/perturbation.hpp"
#include "tangents/study.hpp"
#include "tangents/tangent_table.hpp"

namespace mortise {
namespace {

void refuse_to_overwrite(const TangentsOptions& options, const Comm& comm) {
  on_root(comm, [&] {
    if (options.output && !options.overwrite && std::filesystem::exists(*options.output))
      throw FileError(
          fmt::format("{}: error[I05] exists already - use --overwrite, or another file with -o", options.output->string()));
  });
}

void write(const TangentsOptions& options, const Comm& comm, const std::string& text) {
  if (!options.output) return;
  on_root(comm, [&] {
    write_atomically(*options.output, text);
    std::cout << "table in " << options.output->string() << '\n';
  });
}

ExitCode study(const TangentsOptions& options, const Comm& comm) {
  const std::string text = csv(difference_study());
  write(options, comm, text);
  if (!options.output && comm.getRank() == 0) std::cout << text;
  return ExitCode::done;
}

}  // namespace

ExitCode tangents_command(const TangentsOptions& options, const RCP<const Comm>& comm) {
  refuse_to_overwrite(options, *comm);
  if (!options.deck) return study(options, *comm);
  const bool is_root = comm->getRank() == 0;
  Setup setup(Deck::read(*options.deck), comm);
  StepProblem& problem = setup.problem;
  const Perturbation deformed = perturbed(problem);
  const std::array states{problem.to_overlap(*problem.reference_state()), problem.to_overlap(*deformed.x)};
  if (is_root)
    std::cout << fmt::format("{}, {} ranks; deformed state: {:g} of the full perturbation\n", options.deck->string(),
                             comm->getSize(), deformed.factor);

  const auto terms = checked_terms(problem, setup.partition, options.most);
  std::vector<TermResult> results;
  std::vector<std::string> messages;
  for (const CheckedTerm& term : terms) {
    TermResult result{&term, {}};
    for (std::size_t s = 0; s < states.size(); ++s) {
      result.at[s] = check_tangents(term, data(*states[s]), *comm);
      for (const auto& line : disagreements(term, checked_states[s], result.at[s]))
        messages.push_back(fmt::format("{}: {}", options.deck->string(), line));
    }
    if (is_root) std::cout << '\n' << table(result) << std::flush;
    results.push_back(std::move(result));
  }
  const auto steps = check_steps(problem, *deformed.x);
  for (const StepTangent& step : steps)
    if (!(step.difference <= step_tangent_limit))
      messages.push_back(
          fmt::format("{}: {}, deformed state: differs by {:.1e} from central differences of the residual, more than {:g}",
                      options.deck->string(), step.name, step.difference, step_tangent_limit));
  if (is_root && !steps.empty()) std::cout << '\n' << table(steps) << std::flush;
  write(options, *comm, csv(results, steps));
  if (!messages.empty()) throw UserError(ExitCode::tangent_disagrees, messages);
  if (is_root) std::cout << "\nall tangents agree\n";
  return ExitCode::done;
}

}  // namespace mortise
