#include "commands.hpp"

#include <fmt/format.h>

#include <iostream>

#include "mesh/exodus.hpp"
#include "mesh/suspicions.hpp"
#include "output/run_folder.hpp"
#include "setup.hpp"
#include "solve/linear_solver.hpp"

namespace mortise {

namespace fs = std::filesystem;

ExitCode check_command(const fs::path& file, const RCP<const Comm>& comm) {
  const bool is_root = comm->getRank() == 0;
  if (file.extension() != ".xml") {
    const Mesh mesh = read_exodus(file);
    if (!is_root) return ExitCode::done;
    std::cout << fmt::format("{}: {} nodes, {} elements\n", file.string(), n_nodes(mesh), n_elements(mesh));
    for (const auto& block : mesh.blocks)
      std::cout << fmt::format("  block {} \"{}\": {} {}\n", block.id, block.name, block.elements.size(),
                               topology(block.elements.type()).name);
    for (const auto& set : mesh.side_sets)
      std::cout << fmt::format("  side set {} \"{}\": {} sides\n", set.id, set.name, set.sides.size());
    for (const auto& set : mesh.node_sets)
      std::cout << fmt::format("  node set {} \"{}\": {} nodes\n", set.id, set.name, set.nodes.size());
    for (const auto& warning : mesh_warnings(mesh)) std::cout << "warning: " << warning << '\n';
    std::cout << "the mesh is usable\n";
    return ExitCode::done;
  }
  Setup setup(Deck::read(file), comm);
  setup.first_state();
  const LinearSolver linear(setup.scene, setup.problem.dofs(), setup.scene.solver);
  const std::string text = manifest(setup.deck, setup.problem, linear.choice());  // all ranks have a part in it
  if (is_root) {
    std::cout << text;
    for (const auto& warning : setup.warnings) std::cout << "warning: " << warning << '\n';
    std::cout << "the deck is ready to run\n";
  }
  return ExitCode::done;
}

ExitCode mesh_command(const fs::path& recipe, const fs::path& output, const RCP<const Comm>& comm) {
  if (comm->getRank() != 0) return ExitCode::done;
  const Mesh mesh = make_mesh(read_recipe(recipe), recipe.parent_path());
  write_exodus(mesh, output, recipe.stem().string());
  std::cout << fmt::format("{}: {} nodes, {} elements\n", output.string(), n_nodes(mesh), n_elements(mesh));
  return ExitCode::done;
}

ExitCode describe_command(const std::string& list, bool as_schema, const RCP<const Comm>& comm) {
  if (comm->getRank() == 0) as_schema ? print_schema(std::cout) : print_reference(std::cout, list);
  return ExitCode::done;
}

}  // namespace mortise
