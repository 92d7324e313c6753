// Checks between the lists of a deck that need no mesh.
#include "deck/cross_checks.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "deck/entries.hpp"
#include "deck/field_table.hpp"
#include "deck/fields.hpp"
#include "deck/formula.hpp"
#include "deck/motion_checks.hpp"
#include "deck/names.hpp"
#include "deck/quantities.hpp"
#include "deck/stages.hpp"
#include "errors.hpp"

namespace mortise {

namespace {

/// The mesh of "mesh/set", or of "mesh".
std::string mesh_in(const std::string& set) { return set.substr(0, set.find('/')); }

class CrossChecks {
 public:
  CrossChecks(const DeckSource& source, const DeckOptions& options, Findings& findings)
      : source_(source),
        options_(options),
        findings_(findings),
        meshes_(names_in(options.meshes)),
        known_meshes_(meshes_.begin(), meshes_.end()) {}

  void run() {
    check_bodies();
    check_masses();
    check_strings();
    check_plane_bodies();
    check_sets();
    check_loads();
    check_stages(source_, options_, findings_);
    check_motion(source_, options_, findings_);
    check_contact();
    check_quantities();
    check_times();
    check_tables();
    compile_formulas();
    if (!findings_.problems.empty()) return;
    check_use();
    check_fields();
  }

 private:
  void report(const std::string& code, const std::vector<std::string>& path, const std::string& what) {
    findings_.problems.push_back(source_.problem(code, path, what));
  }

  /// An empty name was missing or faulty, and so was an empty list of meshes: reported already.
  void check_mesh(const std::string& mesh, const std::vector<std::string>& path) {
    if (!mesh.empty() && !meshes_.empty() && known_meshes_.count(mesh) == 0) {
      report("D14", path, not_among("there is no mesh " + in_quotes(mesh), mesh, meshes_));
    }
  }

  void check_bodies() {
    const std::vector<std::string> materials = names_in(options_.materials);
    const std::set<std::string> known_materials(materials.begin(), materials.end());
    std::map<std::string, std::map<std::string, std::string>> owners;  // mesh -> block ("" for all) -> body
    for (const auto& [name, body] : options_.bodies) {
      check_mesh(body.mesh, {"bodies", name, "mesh"});
      if (!body.material.empty() && !materials.empty() && known_materials.count(body.material) == 0) {
        report("D14", {"bodies", name, "material"},
               not_among("there is no material " + in_quotes(body.material), body.material, materials));
      }
      if (!body.mesh.empty()) check_blocks(name, body, owners[body.mesh]);
    }
  }

  /// What moves is known by its name: in initial conditions and body forces.
  void check_masses() {
    const std::vector<std::string> bodies = names_in(options_.bodies);
    for (const auto& [name, masses] : options_.masses) {
      if (std::find(bodies.begin(), bodies.end(), name) != bodies.end())
        report("D11", {"masses", name}, "this is the name of a body already");
      if (masses.set.find('/') == std::string::npos) {
        check_mesh(masses.set, {"masses", name, "set"});
      } else {
        check_set(masses.set, {"masses", name, "set"});
      }
    }
  }

  void check_strings() {
    std::vector<std::string> taken = names_in(options_.bodies);
    for (const auto& masses : options_.masses) taken.push_back(masses.first);
    for (const auto& [name, string] : options_.strings) {
      if (std::find(taken.begin(), taken.end(), name) != taken.end())
        report("D11", {"strings", name}, "this is the name of a body or masses already");
      check_mesh(string.mesh, {"strings", name, "mesh"});
    }
  }

  /// A block belongs to one body.
  void check_blocks(const std::string& name, const BodyOptions& body, std::map<std::string, std::string>& owners) {
    const std::vector<std::string> blocks = body.blocks.empty() ? std::vector<std::string>{""} : body.blocks;
    for (const std::string& block : blocks) {
      auto owner = owners.find(block);
      if (owner == owners.end()) owner = block.empty() ? owners.begin() : owners.find("");
      if (owner != owners.end()) {
        const std::string which = block.empty() ? "some blocks" : "block " + in_quotes(block);
        report("D19", {"bodies", name, body.blocks.empty() ? "mesh" : "blocks"},
               which + " of this mesh belong to body " + in_quotes(owner->second) + " already");
        return;
      }
    }
    for (const std::string& block : blocks) owners.emplace(block, name);
  }

  /// The history has one column for each support, those of bodies in plane strain included.
  void check_plane_bodies() {
    for (const std::string& name : plane_strain_supports(options_))
      for (const auto& support : options_.supports)
        if (support.first == name)
          report("D11", {"supports", name}, "this is the name of the support that a body's \"kinematics\" makes already");
  }
  void check_set(const std::string& set, const std::vector<std::string>& path) {
    if (set.empty()) return;
    const std::size_t slash = set.find('/');
    if (slash == std::string::npos || slash == 0 || slash + 1 == set.size()) {
      report("D14", path, "must be written \"mesh/set\"");
      return;
    }
    check_mesh(set.substr(0, slash), path);
  }

  void check_sets() {
    for (const auto& [name, support] : options_.supports) check_set(support.set, {"supports", name, "set"});
    for (const auto& [name, spring] : options_.springs)
      if (spring.kind) std::visit([&, name = name](const auto& kind) { check_spring(name, kind); }, *spring.kind);
    for (const auto& [name, obstacle] : options_.obstacles) check_set(obstacle.set, {"obstacles", name, "set"});
    for (const auto& [name, rod] : options_.rods) check_mesh(rod.mesh, {"rods", name, "mesh"});
    for (const auto& [name, probe] : options_.probes) check_mesh(probe.mesh, {"probes", name, "mesh"});
  }

  void check_spring(const std::string& name, const springs::Stiffness& spring) {
    check_set(spring.set, {"springs", name, "set"});
  }
  void check_spring(const std::string& name, const springs::Between& spring) {
    check_set(spring.from, {"springs", name, "from"});
    if (spring.formulation == SpringFormulation::augmented && options_.solver.linear == LinearSolverKind::iterative)
      report("D19", {"springs", name, "formulation"},
             "\"augmented\" needs the direct solver - solver > \"linear\" must be \"direct\" or \"auto\"");
    if (!spring.to) return;
    check_set(*spring.to, {"springs", name, "to"});
    if (*spring.to == spring.from) report("D19", {"springs", name, "to"}, "is where the spring begins; it needs two ends");
  }

  void check_loads() {
    for (const auto& [name, load] : options_.loads)
      if (load.kind) std::visit([&, name = name](const auto& kind) { check_load(name, kind); }, *load.kind);
  }
  void check_load(const std::string& name, const loads::OnSides& load) { check_set(load.set, {"loads", name, "set"}); }
  void check_load(const std::string& name, const loads::Pressure& load) { check_set(load.set, {"loads", name, "set"}); }
  void check_load(const std::string& name, const loads::PointForce& load) {
    if (load.set) check_set(*load.set, {"loads", name, "set"});
    if (load.mesh) check_mesh(*load.mesh, {"loads", name, "mesh"});
  }
  void check_load(const std::string& name, const loads::BodyForce& load) {
    const std::vector<std::string> names = moving_names(options_);
    if (load.body && std::find(names.begin(), names.end(), *load.body) == names.end())
      report("D14", {"loads", name, "body"}, not_among("there is no body " + in_quotes(*load.body), *load.body, names));
  }

  template <class Options>
  void check_contact_names(const std::string& list, const Named<Options>& entries, std::set<std::string>& taken) {
    for (const auto& entry : entries)
      if (!taken.insert(entry.first).second)
        report("D11", {list, entry.first}, "this name is taken by an entry of `contact`, `ties`, `obstacles` or `rods` already");
  }

  void check_contact() {
    const std::vector<std::string> pairs = names_in(options_.contact);
    std::set<std::string> taken(pairs.begin(), pairs.end());
    check_contact_names("ties", options_.ties, taken);
    check_contact_names("obstacles", options_.obstacles, taken);
    check_contact_names("rods", options_.rods, taken);
    for (const auto& [name, pair] : options_.contact) {
      if (pair.friction.acts() && options_.solver.linear == LinearSolverKind::iterative)
        report("D19", {"solver", "linear"},
               "cannot be \"iterative\" with friction (contact > " + in_quotes(name) + "): take \"direct\"");
      check_surfaces("contact", name, pair);
    }
    for (const auto& [name, tie] : options_.ties) check_surfaces("ties", name, tie);
  }

  template <class Options>
  void check_surfaces(const std::string& list, const std::string& name, const Options& pair) {
    check_set(pair.secondary, {list, name, "secondary"});
    check_set(pair.primary, {list, name, "primary"});
    if (!pair.primary.empty() && pair.primary == pair.secondary)
      report("D19", {list, name, "primary"}, "is the secondary surface too; a pair needs two surfaces");
  }

  /// Expected columns of the form quantity.entry must name an entry of the deck.
  void check_quantities() {
    std::map<std::string, std::vector<std::string>> entries;
    for (const char* axis : {"x", "y", "z"}) {
      entries[std::string("contact_force_") + axis] = force_names(options_);
      std::vector<std::string>& supports = entries[std::string("reaction_") + axis] = names_in(options_.supports);
      for (const std::string& name : plane_strain_supports(options_)) supports.push_back(name);
    }
    entries["closure_error"] = names_in(options_.contact);
    for (const auto& [name, probe] : options_.probes) {
      if (!probe.quantity.empty()) entries[probe.quantity].push_back(name);
    }
    std::vector<std::string> columns(step_columns.begin(), step_columns.end());
    columns.insert(columns.end(), ledger_columns.begin(), ledger_columns.end());
    columns.insert(columns.end(), balance_columns.begin(), balance_columns.end());
    for (const auto& [quantity, names] : entries) {
      for (const std::string& name : names) columns.push_back(quantity + "." + name);
    }
    const std::set<std::string> known(columns.begin(), columns.end());
    for (const auto& [name, expected] : options_.expected) {
      const std::string& column = expected.quantity;
      if (column.empty() || known.count(column) > 0) continue;
      report("D14", {"expected", name, "quantity"}, not_among("the history has no such column", column, columns));
    }
  }

  void check_times() {
    const std::vector<DeckStage> stages = stages_of(options_);
    const DeckStage& last = stages.back();
    std::vector<double> stops;
    for (const DeckStage& stage : stages) {
      if (!(stage.time->end > 0)) return;  // missing or faulty, and reported
      stops.insert(stops.end(), stage.time->stops.begin(), stage.time->stops.end());
      if (stops.empty() || stops.back() != stage.time->end) stops.push_back(stage.time->end);
    }
    const std::string before_the_end = "must be before " + last.in_words("end") + " = " + shortest(last.time->end);
    for (const auto& [name, expected] : options_.expected) {
      if (expected.at_time && std::find(stops.begin(), stops.end(), *expected.at_time) == stops.end()) {
        std::vector<std::string> allowed;
        for (const double stop : stops) allowed.push_back(shortest(stop));
        const char* where = options_.stages.empty() ? "time > \"stops\" or the end" : "the \"stops\" and ends of the stages";
        report("D08", {"expected", name, "at time"}, std::string("must be one of ") + where + ": " + join(allowed));
      }
      if (expected.mean_from && *expected.mean_from >= last.time->end)
        report("D08", {"expected", name, "mean from"}, before_the_end);
    }
    // What starts when the run is over does nothing.
    for_each_acting_list(options_, [&](const std::string& list, const auto& entries) {
      for (const auto& [name, entry] : entries)
        if (entry.activity.start && *entry.activity.start >= last.time->end) report("D08", {list, name, "start"}, before_the_end);
    });
  }

  /// A table is called in formulas, so its name must be a word that means nothing else there.
  void check_tables() {
    const std::vector<std::string> taken = formula_names();
    for (const auto& [name, table] : options_.tables) {
      const std::vector<std::string> words = names_in_formula(name);
      if (words.size() != 1 || words.front() != name) {
        report("D11", {"tables", name}, "a table is called by its name: letters, digits and _ only, not beginning with a digit");
      } else if (std::find(taken.begin(), taken.end(), name) != taken.end()) {
        report("D11", {"tables", name}, "this name has a meaning in formulas already");
      } else {
        // A faulty table, reported already, still makes its name known.
        const bool is_sound = table.arguments.size() >= 2 && table.arguments.size() == table.values.size();
        callable_.emplace_back(name, is_sound ? table : TableOptions{{0, 1}, {0, 0}});
      }
    }
  }

  void compile_formulas() {
    for (const FormulaUse& use : findings_.formulas) {
      try {
        const Formula compiled(use.text, callable_, use.variables);
      } catch (const std::invalid_argument& fault) {
        report("D16", use.path, std::string("cannot be compiled: ") + fault.what());
      }
    }
  }

  void check_use() {
    std::set<std::string> used_meshes, used_materials, used_tables;
    for (const auto& body : options_.bodies) {
      used_meshes.insert(body.second.mesh);
      used_materials.insert(body.second.material);
    }
    for (const auto& masses : options_.masses) used_meshes.insert(mesh_in(masses.second.set));
    for (const auto& string : options_.strings) used_meshes.insert(string.second.mesh);
    for (const auto& spring : options_.springs)
      if (const auto* between = std::get_if<springs::Between>(&*spring.second.kind)) {
        used_meshes.insert(mesh_in(between->from));
        if (between->to) used_meshes.insert(mesh_in(*between->to));
      }
    for (const FormulaUse& use : findings_.formulas) {
      for (const std::string& name : names_in_formula(use.text)) used_tables.insert(name);
    }
    check_used("meshes", options_.meshes, used_meshes, "is not used by any body, masses or string");
    check_used("materials", options_.materials, used_materials, "is not used by any body");
    check_used("tables", options_.tables, used_tables, "is not used by any formula");
  }

  /// Why the scene does not have a field; empty: it has.
  std::string lack_of(FieldNeed need) const {
    switch (need) {
      case FieldNeed::nothing:
        return "";
      case FieldNeed::inertia:
        return has_inertia(options_) ? "" : "nothing has a velocity in a static run";
      case FieldNeed::supports:
        return options_.supports.empty() ? "the deck has no supports" : "";
      case FieldNeed::contact:
        return contact_names(options_).empty() ? "the deck has no contact" : "";
      case FieldNeed::ties:
        return options_.ties.empty() ? "the deck has no ties" : "";
    }
    return "";
  }

  /// A field that was asked for must be one that the scene has.
  void check_field(const FieldEntry& entry, const std::string& word, const std::vector<std::string>& path) {
    const std::string lack = lack_of(entry.need);
    if (lack.empty()) return;
    std::vector<std::string> allowed;
    for (const FieldEntry& other : field_table)
      if (lack_of(other.need).empty()) allowed.emplace_back(other.name);
    report("D19", path, "there is no " + in_quotes(word) + ": " + lack + "; fields of this deck: " + join(allowed));
  }

  void check_fields() {
    for (const std::string& name : options_.output.fields) check_field(entry_of(field_named(name)), name, {"output", "fields"});
    for (const auto& [name, probe] : options_.probes)
      check_field(entry_of(component_named(probe.quantity).field), probe.quantity, {"probes", name, "quantity"});
  }

  template <class Options>
  void check_used(const std::string& list, const Named<Options>& entries, const std::set<std::string>& used,
                  const std::string& what) {
    for (const auto& entry : entries) {
      if (used.count(entry.first) == 0) report("D15", {list, entry.first}, what);
    }
  }

  const DeckSource& source_;
  const DeckOptions& options_;
  Findings& findings_;
  std::vector<std::string> meshes_;
  std::set<std::string> known_meshes_;
  Named<TableOptions> callable_;
};

}  // namespace

void check_across(const DeckSource& source, const DeckOptions& options, Findings& findings) {
  CrossChecks(source, options, findings).run();
}

}  // namespace mortise
