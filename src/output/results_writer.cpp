#include "output/results_writer.hpp"

#include <algorithm>

#include "output/nodal.hpp"
#include "output/on_root.hpp"

namespace mortise {
namespace {

std::vector<Field> fields_named(const std::vector<std::string>& names) {
  std::vector<Field> fields;
  for (const std::string& name : names) fields.push_back(field_named(name));
  return fields;
}

}  // namespace

ResultsWriter::ResultsWriter(const StepProblem& problem, const History& history, const std::filesystem::path& file, int n_frames)
    : elements_(problem.scene(), fields_named(problem.scene().output.element_fields)) {
  const Scene& scene = problem.scene();
  for (const auto& field : scene.output.fields)
    for (const auto& variable : variables_of_field(field)) nodal_.push_back(variable);
  std::vector<std::string> global;
  for (std::size_t c = 0; c < history.columns().size(); ++c) {
    const std::string& name = history.columns()[c];
    if (name == "step" || name == "time" || name.rfind("seconds", 0) == 0) continue;
    global.push_back(name);
    columns_.push_back(c);
  }
  const ResultsVariables variables{nodal_, global, elements_.variables()};
  on_root(*problem.dofs().comm(), [&] {
    if (n_frames > 0 && std::filesystem::exists(file))
      file_.emplace(file, scene.mesh.mesh, n_frames, variables);
    else
      file_.emplace(file, scene.mesh.mesh, scene.title, variables);
  });
}

void ResultsWriter::observe(const StepProblem& problem, const State& now, const Evaluation& at, const StepRecord& record,
                            const History& history) {
  const OutputOptions& output = problem.scene().output;
  const bool is_asked_for = std::any_of(output.times.begin(), output.times.end(),
                                        [&](double t) { return t > record.time - record.dt && t <= record.time; });
  if (record.step > 0 && !record.is_stop && !is_asked_for && record.step % output.every != 0) {
    left_out_ = {now, at};
    return;
  }
  write(problem, now, at, history);
}

void ResultsWriter::write_last(const StepProblem& problem, const History& history) {
  if (!left_out_) return;
  const auto [now, at] = *left_out_;
  write(problem, now, at, history);
}

void ResultsWriter::write(const StepProblem& problem, const State& now, const Evaluation& at, const History& history) {
  left_out_.reset();
  ResultsFrame frame{nodal_variables(problem, now, at, nodal_), {}, elements_.values(problem, now)};
  for (std::size_t c : columns_) frame.global.push_back(history.rows().back()[c]);
  on_root(*problem.dofs().comm(), [&] { file_->write(now.time, frame); });
}

}  // namespace mortise
