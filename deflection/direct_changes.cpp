#include "deflection/direct_changes.hpp"

namespace tubeplan::deflection {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

using VectorChanges = Eigen::Matrix<double, 3, kDualSize, Eigen::RowMajor>;
using NumberChanges = Eigen::Matrix<double, 1, kDualSize>;

NumberChanges changesOf(const Dual& x) { return Eigen::Map<const NumberChanges>(x.derivatives().data()); }

VectorChanges changesOf(const Vector3<Dual>& v) {
  VectorChanges out;
  for (int i = 0; i < 3; ++i) out.row(i) = changesOf(v[i]);
  return out;
}

/// Returns the rotation vector of the change of R, in the axes into which R transforms: the vee of dR R^T.
VectorChanges spinOf(const Matrix3<Dual>& R) {
  VectorChanges out = VectorChanges::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.row(i) += R((i + 1) % 3, j).value() * changesOf(R((i + 2) % 3, j));
  return out;
}

bool changes(const Matrix3<Dual>& R) {
  for (int i = 0; i < 9; ++i)
    if (deflection::changes(R.data()[i])) return true;
  return false;
}

/// Adds rows * columns to `tip`. Zeros are not skipped, because both matrices are small.
template <class Rows, class Columns>
void addProduct(const Rows& rows, const Columns& columns, TipColumns& tip) {
  for (int k = 0; k < rows.cols(); ++k)
    for (int slot = 0; slot < kDualSize; ++slot) tip.col(slot) += rows.col(k) * columns(k, slot);
}

}  // namespace

bool changes(const Dual& x) {
  double sum = 0;
  for (const double d : x.derivatives()) sum += std::abs(d);
  return sum != 0;
}

bool changes(const Vector3<Dual>& v) { return changes(v.x()) || changes(v.y()) || changes(v.z()); }

void addMotion(const PoseOf<Dual>& frame, const Vector3d& p, TipColumns& tip) {
  const VectorChanges spin = spinOf(frame.R);
  tip.topRows<3>() += changesOf(frame.p) - crossMatrix<double>(p) * spin;
  tip.bottomRows<3>() += spin;
}

void addToolTurn(const Vector3<Dual>& turn_L, const Matrix3d& R_BL, TipColumns& tip) {
  if (changes(turn_L)) tip.bottomRows<3>() += R_BL * spinOf(rotationFromVector<Dual>(turn_L));
}

void DirectChanges::begin() {
  first_link_.clear();
  first_element_.clear();
  std::size_t element = 0;
  for (std::size_t k = 0; k < arm_.chain().links.size(); ++k) {
    if (arm_.chain().links[k].row == static_cast<int>(first_link_.size())) {
      first_link_.push_back(k);
      first_element_.push_back(element);
    }
    element += arm_.chain().links[k].component >= 0;
  }
}

void DirectChanges::addLink(std::size_t k, const ChainLink<Dual>& link, TipColumns& tip) const {
  const PoseOf<double>& near = sensitivity_.frames()[k];
  const Vector3d& g = arm_.effectivePosture().gravity_B;
  const double weight = link.weight.value();
  const Vector3d middle = (near.p + sensitivity_.frames()[k + 1].p) / 2;
  const Vector3d lever = near.R * valuesOf(link.lever);
  if (changes(link.weight)) {
    const Vector3d place = link.type == ChainLinkType::kLump ? Vector3d(near.p + lever) : middle;
    addProduct(Eigen::Matrix<double, 6, 1>(sensitivity_.forceAt(k, place) * g), changesOf(link.weight), tip);
  }
  if (changes(link.p)) {
    const TipRows shift =
        (sensitivity_.shiftAt(k) - sensitivity_.momentAt(k) * crossMatrix<double>(g * (weight / 2))) * near.R;
    addProduct(shift, changesOf(link.p), tip);
  }
  if (link.type == ChainLinkType::kTurn && changes(link.R))
    addProduct(TipRows(sensitivity_.turnAt(k, near.p) * near.R), spinOf(link.R), tip);
  if (link.type == ChainLinkType::kLump && changes(link.lever))
    addProduct(TipRows(-sensitivity_.momentAt(k) * crossMatrix<double>(g * weight) * near.R), changesOf(link.lever),
               tip);
}

void DirectChanges::addElement(std::size_t e, const ChainLink<Dual>& link, const Row<Dual>& row,
                               TipColumns& tip) const {
  const FlexibleElement& element = arm_.equilibrium().elements[e];
  const ElementSensitivity& answer = sensitivity_.element(e);
  if (changes(link.weight))
    addProduct(Eigen::Matrix<double, 6, 1>(answer.weight * arm_.effectivePosture().gravity_B), changesOf(link.weight),
               tip);
  if (changes(link.p)) addProduct(answer.displacement, changesOf(link.p), tip);
  const Flexibility<Dual> flexibility = element.kind->flexibilityOfDual(row, link.p);
  for (int axis = 0; axis < 3; ++axis)
    if (element.has_gap[axis])
      addProduct(Eigen::Matrix<double, 6, 1>(answer.rotation.col(axis) * answer.gap_positions[axis].by_gap),
                 changesOf(row.effect_terms->gap[axis]), tip);
  if (!changes(flexibility.compliance) && !changes(flexibility.softness) && !changes(flexibility.knee) &&
      !changes(flexibility.member))
    return;
  const Deflection<Dual> deflected = element.kind->deflectDual(flexibility, arm_.equilibrium().loadingOf(e));
  if (changes(deflected.displacement)) addProduct(answer.displacement, changesOf(deflected.displacement), tip);
  if (changes(deflected.rotation)) addProduct(answer.rotation, changesOf(deflected.rotation), tip);
}

void DirectChanges::addRow(std::size_t index, const Row<Dual>& row, const Dual& reading, const Vector3<Dual>& to_next,
                           TipColumns& tip) {
  const Arm& values = arm_.effective();
  chain_.links.clear();
  chain_.components.clear();
  assembleRow<Dual>(chain_, row, values.rows[index], static_cast<int>(index), reading, to_next);
  std::size_t e = first_element_[index];
  for (std::size_t l = 0; l < chain_.links.size(); ++l) {
    const ChainLink<Dual>& link = chain_.links[l];
    const std::size_t k = first_link_[index] + l;
    if (link.component >= 0)
      addElement(e++, link, row, tip);
    else
      addLink(k, link, tip);
    if (link.type == ChainLinkType::kEndWeight && row.effect_terms && changes(row.effect_terms->end_force))
      addProduct(sensitivity_.forceAt(k, sensitivity_.frames()[k].p), changesOf(row.effect_terms->end_force), tip);
  }
}

void DirectChanges::addElements(std::size_t index, const Row<Dual>& row, TipColumns& tip) {
  std::size_t e = first_element_[index];
  for (; e < arm_.equilibrium().elements.size(); ++e) {
    if (arm_.chain().components[e].row != static_cast<int>(index)) return;
    ChainLink<Dual> link{ChainLinkType::kMember, static_cast<int>(index)};
    link.p = arm_.equilibrium().elements[e].flexibility.member.cast<Dual>();
    addElement(e, link, row, tip);
  }
}

void DirectChanges::addTurn(std::size_t index, const Dual& reading, TipColumns& tip) const {
  const std::size_t k = first_link_[index] + (index == 0);
  const PoseOf<double>& far = sensitivity_.frames()[k + 1];
  addProduct(Eigen::Matrix<double, 6, 1>(sensitivity_.turnAt(k, far.p) * far.R.col(2)), changesOf(reading), tip);
}

void DirectChanges::addGravity(const Vector3<Dual>& gravity_B, TipColumns& tip) const {
  if (changes(gravity_B)) addProduct(sensitivity_.gravity(), changesOf(gravity_B), tip);
}

void DirectChanges::addTipLoad(const Dual& load, const std::optional<TipLoad<Dual>>& added, TipColumns& tip) const {
  const Vector3d& g = arm_.effectivePosture().gravity_B;
  const std::size_t last = arm_.chain().links.size() - 1;
  const PoseOf<double>& end = sensitivity_.frames().back();
  const Dual size = added ? Dual(load - added->contact_force) : load;
  if (changes(size))
    addProduct(Eigen::Matrix<double, 6, 1>(sensitivity_.forceAt(last, end.p) * g), changesOf(size), tip);
  if (!added) return;
  if (changes(added->force)) addProduct(sensitivity_.forceAt(last, end.p), changesOf(added->force), tip);
  if (changes(added->moment)) addProduct(sensitivity_.momentAt(last), changesOf(added->moment), tip);
  const Vector3<Dual> moment = added->payload_offset * load;
  if (changes(moment))
    addProduct(TipRows(-sensitivity_.momentAt(last) * crossMatrix<double>(g) * end.R), changesOf(moment), tip);
}

}  // namespace tubeplan::deflection
