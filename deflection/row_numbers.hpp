// Every number of a row, visited side by side with the same number of another row of its shape.
#pragma once

#include <cassert>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

/// Calls `visit(a, b)` for each component of two vectors.
template <class A, class B, class Visit>
void visitVectors(Vector3<A>& a, const Vector3<B>& b, Visit&& visit) {
  for (int k = 0; k < 3; ++k) visit(a[k], b[k]);
}

template <class A, class B, class Visit>
void visitPlacements(Row<A>& a, const Row<B>& b, Visit&& visit) {
  assert(a.placement.index() == b.placement.index());
  if (auto* dh = std::get_if<DenavitHartenberg<A>>(&a.placement)) {
    const auto& other = std::get<DenavitHartenberg<B>>(b.placement);
    visit(dh->alpha, other.alpha);
    visit(dh->a, other.a);
    visit(dh->d, other.d);
    visit(dh->theta, other.theta);
    return;
  }
  auto& origin = std::get<Origin<A>>(a.placement);
  const auto& other = std::get<Origin<B>>(b.placement);
  visitVectors(origin.position, other.position, visit);
  visitVectors(origin.rpy, other.rpy, visit);
}

/// What effects add to what gives.
template <class A, class B, class Visit>
void visitEffectTerms(EffectTerms<A>& a, const EffectTerms<B>& b, Visit&& visit) {
  visitVectors(a.compliance, b.compliance, visit);
  visitVectors(a.softness, b.softness, visit);
  visitVectors(a.knee, b.knee, visit);
  visitVectors(a.gap, b.gap, visit);
  visitVectors(a.bending_compliance, b.bending_compliance, visit);
  visit(a.torsion_compliance, b.torsion_compliance);
}

/// What gives at a row's origin and along its member. An addition that one of the rows has not is passed over.
template <class A, class B, class Visit>
void visitFlexibilities(Row<A>& a, const Row<B>& b, Visit&& visit) {
  visitVectors(a.joint_stiffness, b.joint_stiffness, visit);
  assert(a.beam.has_value() == b.beam.has_value());
  if (a.beam) {
    visit(a.beam->E, b.beam->E);
    visitVectors(a.beam->I, b.beam->I, visit);
    visit(a.beam->G, b.beam->G);
    visit(a.beam->J, b.beam->J);
  }
  if (a.effect_terms && b.effect_terms) visitEffectTerms(*a.effect_terms, *b.effect_terms, visit);
}

/// The joint's offset, and what weighs or pulls.
template <class A, class B, class Visit>
void visitLoads(Row<A>& a, const Row<B>& b, Visit&& visit) {
  visit(a.joint.offset, b.joint.offset);
  visit(a.weight.distributed, b.weight.distributed);
  visit(a.weight.end, b.weight.end);
  assert(a.weight.lumps.size() == b.weight.lumps.size());
  for (std::size_t k = 0; k < a.weight.lumps.size(); ++k) {
    visit(a.weight.lumps[k].weight, b.weight.lumps[k].weight);
    visitVectors(a.weight.lumps[k].at, b.weight.lumps[k].at, visit);
  }
  if (!a.effect_terms || !b.effect_terms) return;
  visitVectors(a.effect_terms->pull, b.effect_terms->pull, visit);
  assert(a.effect_terms->hung.size() == b.effect_terms->hung.size());
  for (std::size_t k = 0; k < a.effect_terms->hung.size(); ++k) {
    visit(a.effect_terms->hung[k].weight, b.effect_terms->hung[k].weight);
    visitVectors(a.effect_terms->hung[k].at, b.effect_terms->hung[k].at, visit);
  }
}

}  // namespace tubeplan::deflection
