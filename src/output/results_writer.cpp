#include "output/results_writer.hpp"

#include "output/on_root.hpp"

namespace mortise {

ResultsWriter::ResultsWriter(const StepProblem& problem, const History& history, const std::filesystem::path& file,
                             int n_frames) {
  const Scene& scene = problem.scene();
  for (const auto& field : scene.output.fields)
    for (const auto& variable : variables_of_field(field)) nodal_.push_back(variable);
  for (std::size_t c = 0; c < history.columns().size(); ++c) {
    const std::string& name = history.columns()[c];
    if (name == "step" || name == "time" || name.rfind("seconds", 0) == 0) continue;
    global_.push_back(name);
    columns_.push_back(c);
  }
  on_root(*problem.dofs().comm(), [&] {
    if (n_frames > 0 && std::filesystem::exists(file))
      file_.emplace(file, scene.mesh.mesh, n_frames, nodal_, global_);
    else
      file_.emplace(file, scene.mesh.mesh, scene.title, nodal_, global_);
  });
}

void ResultsWriter::observe(const StepProblem& problem, const State& now, const Evaluation& at, const StepRecord& record,
                            const History& history) {
  if (record.step > 0 && !record.is_stop && record.step % problem.scene().output.every != 0) {
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
  std::vector<std::vector<double>> fields;
  for (const auto& name : nodal_) fields.push_back(nodal_quantity(problem, now, at, name));
  std::vector<double> globals;
  for (std::size_t c : columns_) globals.push_back(history.rows().back()[c]);
  on_root(*problem.dofs().comm(), [&] { file_->write(now.time, fields, globals); });
}

}  // namespace mortise
