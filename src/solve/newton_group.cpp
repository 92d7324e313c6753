#include "solve/newton_group.hpp"

#include <Teuchos_Time.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>

namespace mortise {
namespace {

using Extract = Thyra::TpetraOperatorVectorExtraction<double, int, GlobalIndex>;

RCP<Vector> tpetra(const NOX::Thyra::Vector& v) {
  return Extract::getTpetraVector(Teuchos::rcp_const_cast<Thyra::VectorBase<double>>(v.getThyraRCPVector()));
}

}  // namespace

Teuchos::RCP<NOX::Thyra::Vector> wrap(const RCP<Vector>& v) {
  const auto space = Thyra::createVectorSpace<double, int, GlobalIndex>(v->getMap());
  return Teuchos::rcp(new NOX::Thyra::Vector(Thyra::createVector<double, int, GlobalIndex>(v, space)));
}

const Vector& unwrap(const NOX::Abstract::Vector& v) { return *tpetra(dynamic_cast<const NOX::Thyra::Vector&>(v)); }
Vector& unwrap(NOX::Abstract::Vector& v) { return *tpetra(dynamic_cast<const NOX::Thyra::Vector&>(v)); }

NewtonGroup::NewtonGroup(std::shared_ptr<NewtonShared> shared, const RCP<Vector>& x)
    : shared_(std::move(shared)),
      x_(wrap(x)),
      f_(wrap(Teuchos::rcp(new Vector(x->getMap())))),
      direction_(wrap(Teuchos::rcp(new Vector(x->getMap())))) {}

NewtonGroup::NewtonGroup(const NewtonGroup& source, NOX::CopyType type) : shared_(source.shared_) {
  const auto copy = [type](const NOX::Abstract::Vector& v) {
    return Teuchos::rcp_dynamic_cast<NOX::Thyra::Vector>(v.clone(type));
  };
  x_ = copy(*source.x_);
  f_ = copy(*source.f_);
  direction_ = copy(*source.direction_);
  if (type == NOX::DeepCopy) {
    evaluation_ = source.evaluation_;
    has_direction_ = source.has_direction_;
  }
}

NOX::Abstract::Group& NewtonGroup::operator=(const NOX::Abstract::Group& source) {
  const auto& other = dynamic_cast<const NewtonGroup&>(source);
  *x_ = *other.x_;
  *f_ = *other.f_;
  *direction_ = *other.direction_;
  evaluation_ = other.evaluation_;
  has_direction_ = other.has_direction_;
  tangent_ = Teuchos::null;  // the one tangent belongs to the problem and may be of another state by now
  return *this;
}

void NewtonGroup::setX(const NOX::Abstract::Vector& y) {
  *x_ = y;
  evaluation_ = nullptr;
  tangent_ = Teuchos::null;
  has_direction_ = false;
}

void NewtonGroup::computeX(const NOX::Abstract::Group& group, const NOX::Abstract::Vector& d, double step) {
  x_->update(1.0, group.getX(), step, d, 0.0);
  evaluation_ = nullptr;
  tangent_ = Teuchos::null;
  has_direction_ = false;
}

NOX::Abstract::Group::ReturnType NewtonGroup::computeF() {
  if (evaluation_) return evaluation_->admissible ? Ok : Failed;
  evaluation_ = std::make_shared<const Evaluation>(shared_->problem.evaluate(unwrap(*x_)));
  if (!evaluation_->admissible) return Failed;
  unwrap(*f_).update(1.0, *evaluation_->residual, 0.0);
  return Ok;
}

NOX::Abstract::Group::ReturnType NewtonGroup::computeJacobian() {
  evaluation_ = std::make_shared<const Evaluation>(shared_->problem.linearise(unwrap(*x_), tangent_));
  if (!evaluation_->admissible) return Failed;
  unwrap(*f_).update(1.0, *evaluation_->residual, 0.0);
  return Ok;
}

NOX::Abstract::Group::ReturnType NewtonGroup::computeNewton(Teuchos::ParameterList&) {
  if (!isJacobian()) return BadDependency;
  const double begin = Teuchos::Time::wallTime();
  Vector& d = unwrap(*direction_);
  shared_->last_linear = find_direction(shared_->problem, unwrap(*x_), *evaluation_, *tangent_, shared_->linear, d);
  shared_->seconds_linear += Teuchos::Time::wallTime() - begin;
  has_direction_ = true;
  if (shared_->last_linear.solved) return Ok;
  d.putScalar(0.0);
  return Failed;
}

NOX::Abstract::Group::ReturnType NewtonGroup::applyJacobian(const NOX::Abstract::Vector& input,
                                                            NOX::Abstract::Vector& result) const {
  if (!isJacobian()) return BadDependency;
  tangent_->apply(unwrap(input), unwrap(result));
  return Ok;
}

Teuchos::RCP<NOX::Abstract::Group> NewtonGroup::clone(NOX::CopyType type) const {
  return Teuchos::rcp(new NewtonGroup(*this, type));
}

}  // namespace mortise
