#include "deflection/weights.hpp"

#include "deflection/chain.hpp"

namespace tubeplan::deflection {

RowWeight rowWeightOf(const Arm& arm, std::size_t row) {
  const Weight<double>& stated = arm.rows.at(row).weight;
  const Eigen::Vector3d member = offsetToNext<double>(arm, row);
  const double distributed = stated.distributed * member.norm();
  RowWeight sum{stated.end + distributed, stated.end * member + distributed * member / 2};
  for (const auto& lump : stated.lumps) {
    sum.weight += lump.weight;
    sum.moment_R += lump.weight * lump.at;
  }
  return sum;
}

double weightOf(const Arm& arm) {
  double sum = 0;
  for (std::size_t row = 0; row < arm.rows.size(); ++row) sum += rowWeightOf(arm, row).weight;
  return sum;
}

}  // namespace tubeplan::deflection
