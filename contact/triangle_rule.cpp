#include "contact/triangle_rule.hpp"

#include <cassert>
#include <cmath>

namespace mortise {
namespace {

void add_3(std::vector<TrianglePoint>& rule, double weight, double a) {
  const double b = 1 - 2 * a;
  rule.insert(rule.end(), {{b, a, a, weight}, {a, b, a, weight}, {a, a, b, weight}});
}

void add_6(std::vector<TrianglePoint>& rule, double weight, double a, double b) {
  const double c = 1 - a - b;
  rule.insert(rule.end(),
              {{a, b, c, weight}, {b, c, a, weight}, {c, a, b, weight}, {a, c, b, weight}, {c, b, a, weight}, {b, a, c, weight}});
}

// Thesis Tab. 4.1.
std::vector<TrianglePoint> degree_3() {
  std::vector<TrianglePoint> rule{{1.0 / 3, 1.0 / 3, 1.0 / 3, -27.0 / 48}};
  add_3(rule, 25.0 / 48, 0.2);
  return rule;
}

std::vector<TrianglePoint> degree_4() {
  std::vector<TrianglePoint> rule;
  add_3(rule, 0.22338158967801146570, 0.44594849091596488632);
  add_3(rule, 0.10995174365532186764, 0.09157621350977074346);
  return rule;
}

std::vector<TrianglePoint> degree_5() {
  const double root = std::sqrt(15.0);
  std::vector<TrianglePoint> rule{{1.0 / 3, 1.0 / 3, 1.0 / 3, 0.225}};
  add_3(rule, (155 - root) / 1200, (6 - root) / 21);
  add_3(rule, (155 + root) / 1200, (6 + root) / 21);
  return rule;
}

std::vector<TrianglePoint> degree_6() {
  std::vector<TrianglePoint> rule;
  add_3(rule, 0.11678627572637936603, 0.24928674517091042129);
  add_3(rule, 0.05084490637020681692, 0.06308901449150222834);
  add_6(rule, 0.08285107561837357519, 0.31035245103378440542, 0.63650249912139864723);
  return rule;
}

std::vector<TrianglePoint> degree_8() {
  std::vector<TrianglePoint> rule{{1.0 / 3, 1.0 / 3, 1.0 / 3, 0.14431560767778716825}};
  add_3(rule, 0.09509163426728462479, 0.45929258829272315603);
  add_3(rule, 0.10321737053471825028, 0.17056930775176020663);
  add_3(rule, 0.03245849762319808031, 0.05054722831703097545);
  add_6(rule, 0.02723031417443499426, 0.26311282963463811342, 0.72849239295540428124);
  return rule;
}

}  // namespace

const std::vector<TrianglePoint>& triangle_rule(int degree) {
  static const std::vector<TrianglePoint> rules[] = {degree_3(), degree_4(), degree_5(), degree_6(), degree_8()};
  assert(degree >= 3 && degree <= 8);
  return rules[degree <= 6 ? degree - 3 : 4];
}

}  // namespace mortise
