// The step problem as NOX sees it: a group of solution, residual, tangent and Newton direction.
#pragma once

#include <NOX_Abstract_Group.H>
#include <NOX_Thyra_Vector.H>

#include <functional>

#include "solve/active_set.hpp"
#include "solve/newton.hpp"

namespace mortise {

/// Shared by all groups of one solve: the problem, the linear solver, and what was learnt on the way.
struct NewtonShared {
  StepProblem& problem;
  LinearSolver& linear;
  double& seconds_linear;
  DirectionReport last_linear{};
  bool halve_next = false;  ///< the active set has cycled: the line search takes half a step
  double last_step_length = 1;
  std::string refused{};  ///< what a formula of friction missed at the last trial state that was refused for it
  std::string refusal_in_words() const { return refused.empty() ? "" : "; trial states were refused: " + refused; }
};

/// Wraps Tpetra vectors for NOX.
Teuchos::RCP<NOX::Thyra::Vector> wrap(const RCP<Vector>& v);
const Vector& unwrap(const NOX::Abstract::Vector& v);
Vector& unwrap(NOX::Abstract::Vector& v);

/// Solution x, residual F, Newton direction; evaluations are shared and not repeated.
class NewtonGroup : public NOX::Abstract::Group {
 public:
  NewtonGroup(std::shared_ptr<NewtonShared> shared, const RCP<Vector>& x);
  NewtonGroup(const NewtonGroup& source, NOX::CopyType type);

  NOX::Abstract::Group& operator=(const NOX::Abstract::Group& source) override;
  void setX(const NOX::Abstract::Vector& y) override;
  void computeX(const NOX::Abstract::Group& group, const NOX::Abstract::Vector& d, double step) override;
  ReturnType computeF() override;
  ReturnType computeJacobian() override;
  ReturnType computeNewton(Teuchos::ParameterList& params) override;
  ReturnType applyJacobian(const NOX::Abstract::Vector& input, NOX::Abstract::Vector& result) const override;

  bool isF() const override { return evaluation_ != nullptr; }
  bool isJacobian() const override { return !tangent_.is_null(); }
  bool isNewton() const override { return has_direction_; }
  const NOX::Abstract::Vector& getX() const override { return *x_; }
  const NOX::Abstract::Vector& getF() const override { return *f_; }
  double getNormF() const override { return f_->norm(); }
  const NOX::Abstract::Vector& getGradient() const override { return *f_; }
  const NOX::Abstract::Vector& getNewton() const override { return *direction_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getXPtr() const override { return x_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getFPtr() const override { return f_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getGradientPtr() const override { return f_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getNewtonPtr() const override { return direction_; }
  Teuchos::RCP<NOX::Abstract::Group> clone(NOX::CopyType type = NOX::DeepCopy) const override;

  const Evaluation& evaluation() const { return *evaluation_; }

 private:
  std::shared_ptr<NewtonShared> shared_;
  Teuchos::RCP<NOX::Thyra::Vector> x_, f_, direction_;
  std::shared_ptr<const Evaluation> evaluation_;
  RCP<Matrix> tangent_;
  bool has_direction_ = false;
};

}  // namespace mortise
