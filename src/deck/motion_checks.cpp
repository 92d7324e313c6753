#include "deck/motion_checks.hpp"

#include <algorithm>
#include <set>

#include "deck/entries.hpp"
#include "deck/stages.hpp"

namespace mortise {
namespace {

class MotionChecks {
 public:
  MotionChecks(const DeckSource& source, const DeckOptions& options, Findings& findings)
      : source_(source),
        options_(options),
        findings_(findings),
        stages_(stages_of(options)),
        moving_(std::find_if(stages_.begin(), stages_.end(), [](const DeckStage& s) { return s.scheme().has_inertia(); })),
        is_moving_(moving_ != stages_.end()) {}

  void run() {
    check_body_forces();
    check_bodies();
    check_strings();
    check_initial_conditions();
    for (const DeckStage& stage : stages_) check_scheme(stage);
  }

 private:
  void report(const std::string& code, const std::vector<std::string>& path, const std::string& what) {
    findings_.problems.push_back(source_.problem(code, path, what));
  }

  void check_body_forces() {
    for (const auto& [name, load] : options_.loads) {
      if (!load.kind || !std::holds_alternative<loads::BodyForce>(*load.kind)) continue;
      const auto& on = std::get<loads::BodyForce>(*load.kind).body;
      const std::string why = "the body force " + in_quotes(name) + " needs it";
      for (const auto& [string_name, string] : options_.strings)
        if (!on || *on == string_name) check_density(string_name, string, why);
      for (const auto& [body_name, body] : options_.bodies)
        if (!on || *on == body_name) check_density(body, why);
    }
  }

  void check_bodies() {
    for (const auto& [name, body] : options_.bodies) {
      if (body.rayleigh.mass > 0) check_density(body, "\"rayleigh mass\" of body " + in_quotes(name) + " needs it");
      if (is_moving_) check_density(body, moving_->with_scheme() + " needs it");
      if (!is_moving_ && !(body.rayleigh.mass > 0) && is_set("bodies", name, "mass"))
        report("D13", {"bodies", name, "mass"},
               "is set but unused: it has a meaning only with \"rayleigh mass\" > 0 and in dynamics");
      for (const DeckStage& stage : stages_) check_formulation(name, body, stage);
    }
  }

  void check_strings() {
    for (const auto& [name, string] : options_.strings)
      if (is_moving_) check_density(name, string, moving_->with_scheme() + " needs it");
  }

  /// What moves by its mass needs a density; each material and string is told once.
  void check_density(const BodyOptions& body, const std::string& why) {
    for (const auto& [name, material] : options_.materials)
      if (name == body.material && !material.density) miss_density({"materials", name}, why);
  }
  void check_density(const std::string& name, const StringOptions& string, const std::string& why) {
    if (!string.density) miss_density({"strings", name}, why);
  }
  void miss_density(const std::vector<std::string>& path, const std::string& why) {
    if (told_.insert(path).second) report("D07", path, "required \"density\" is missing: " + why);
  }

  bool is_set(const std::string& list, const std::string& name, const std::string& parameter) const {
    return source_.root().list(list)->list(name)->parameter(parameter) != nullptr;
  }

  void check_initial_conditions() {
    const std::vector<std::string> names = moving_names(options_);
    for (const auto& [name, initial] : options_.initial_conditions) {
      if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end())
        report("D14", {"initial conditions", name}, not_among("there is no body " + in_quotes(name), name, names));
      if (!is_moving_ && !initial.state)
        report("D13", {"initial conditions", name},
               "is set but unused: it has a meaning only in dynamics, and " +
                   (options_.stages.empty() ? "time > \"scheme\" is " + in_quotes(name_of_kind(options_.time.scheme))
                                            : "no stage has inertia"));
    }
  }

  void check_scheme(const DeckStage& stage) {
    const auto has_any = [&](const std::string& list, const auto& entries) {
      return std::any_of(entries.begin(), entries.end(), [&](const auto& entry) { return stage.has(list, entry.first); });
    };
    const bool has_pairs = has_any("contact", options_.contact);
    const bool has_contact =
        has_pairs || has_any("ties", options_.ties) || has_any("obstacles", options_.obstacles) || has_any("rods", options_.rods);
    const TimeScheme scheme = stage.scheme();
    const bool has_multipliers = has_any("ties", options_.ties) || has_any("obstacles", options_.obstacles) ||
                                 has_any("rods", options_.rods) ||
                                 std::any_of(options_.contact.begin(), options_.contact.end(), [&](const auto& pair) {
                                   return stage.has("contact", pair.first) && pair.second.enforcement != Enforcement::penalty;
                                 });
    if (const std::string fault = instability(stage.time->scheme, has_multipliers && !is_redistributed()); !fault.empty())
      report("D19", stage.at("scheme"), fault);
    if (has_pairs && scheme.has_discrete_contact)
      report("D19", stage.at("scheme"),
             "has no discrete gradient of the mortar gap yet - take \"energy momentum midpoint contact\"");
    for (const auto& [name, contact] : options_.contact) {
      check_closing({"contact", name}, contact.closing, stage);
      if (contact.friction.acts() && stage.has("contact", name) &&
          (scheme.forces == ForceReading::mean || scheme.constraint_theta == 0))
        report("D19", {"contact", name, contact.friction.law()},
               "cannot stand with " + stage.with_scheme() +
                   ", whose contact forces do not act at one time in the step after its start");
    }
    for (const auto& [name, obstacle] : options_.obstacles) check_closing({"obstacles", name}, obstacle.closing, stage);
    if (scheme.is_explicit_in_position &&
        (has_contact || has_any("supports", options_.supports) || !plane_strain_supports(options_).empty()))
      report("D19", stage.at("scheme"), "takes no supports and no contact, ties, obstacles or rods: it is explicit");
    for (const auto& [name, spring] : options_.springs) {
      const auto* between = spring.kind ? std::get_if<springs::Between>(&*spring.kind) : nullptr;
      if (between && between->formulation == SpringFormulation::augmented && scheme.is_explicit_in_position)
        report("D19", {"springs", name, "formulation"},
               "cannot be \"augmented\" for " + stage.with_scheme() + ", which is explicit");
    }
  }

  /// A jump of velocities does not fit a scheme that goes on with accelerations.
  void check_closing(const std::vector<std::string>& path, Closing closing, const DeckStage& stage) {
    if (closing == Closing::velocity_update && stage.has(path[0], path[1]) && stage.scheme().alpha)
      report("D19", {path[0], path[1], "closing"},
             "cannot be \"velocity update\" for " + stage.with_scheme() + ", which carries accelerations on - take \"position\"");
  }

  /// Whether no mass stands at nodes that touch.
  bool is_redistributed() const {
    return options_.masses.empty() && options_.strings.empty() &&
           std::all_of(options_.bodies.begin(), options_.bodies.end(),
                       [](const auto& body) { return body.second.mass == MassKind::redistributed; });
  }

  /// Which formulations know the forces of a scheme.
  void check_formulation(const std::string& name, const BodyOptions& body, const DeckStage& stage) {
    const ForceReading forces = stage.scheme().forces;
    if (forces == ForceReading::algorithmic && body.formulation != FormulationKind::standard)
      report("D19", {"bodies", name, "formulation"},
             "must be \"standard\" for " + stage.with_scheme() + ", whose stress is that of displacement elements");
    if (forces == ForceReading::mean && body.formulation == FormulationKind::mixed)
      report("D19", {"bodies", name, "formulation"},
             "cannot be \"mixed\" where " + stage.with_scheme() + " takes the mean of two forces");
  }

  const DeckSource& source_;
  const DeckOptions& options_;
  Findings& findings_;
  const std::vector<DeckStage> stages_;
  const std::vector<DeckStage>::const_iterator moving_;  ///< the first stage with inertia
  const bool is_moving_;
  std::set<std::vector<std::string>> told_;  ///< of missing densities
};

}  // namespace

void check_motion(const DeckSource& source, const DeckOptions& options, Findings& findings) {
  MotionChecks(source, options, findings).run();
}

}  // namespace mortise
