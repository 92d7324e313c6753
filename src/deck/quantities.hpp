// Names of history columns that do not depend on the scene: written by the history, known to the deck's `expected`.
#pragma once

#include <array>

namespace mortise {

inline constexpr std::array step_columns{"step", "time", "dt", "newton_iterations", "cuts", "active", "stick", "slip"};

/// The ledger and the momenta (conventions, section 7).
inline constexpr std::array ledger_columns{"kinetic_energy",
                                           "strain_energy",
                                           "stick_energy",
                                           "total_energy",
                                           "external_work",
                                           "contact_work",
                                           "contact_work_closing",
                                           "contact_work_resegmentation",
                                           "friction_dissipation",
                                           "damping_dissipation",
                                           "algorithmic_dissipation",
                                           "residual_work",
                                           "ledger_mismatch",
                                           "linear_momentum_x",
                                           "linear_momentum_y",
                                           "linear_momentum_z",
                                           "angular_momentum_x",
                                           "angular_momentum_y",
                                           "angular_momentum_z"};

/// Columns after those of the conventions: |momentum - (momentum at the start + impulses of loads, supports, damping, springs to
/// the ground, obstacles, rods and the residual)|.
inline constexpr std::array balance_columns{"linear_momentum_mismatch", "angular_momentum_mismatch"};

}  // namespace mortise
