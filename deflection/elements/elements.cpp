// The element table: the laws of all flexible components of an arm.
#include <array>

#include "deflection/elements/beam.hpp"
#include "deflection/elements/element.hpp"
#include "deflection/elements/joint_stiffness.hpp"

namespace tubeplan::deflection {

std::span<const ElementKind> elementKinds() {
  static constexpr std::array kKinds{
      ElementKind{"joint_stiffness", "rotation = moment / stiffness, about each axis (2.17)", ElementPlace::kOrigin,
                  joint_stiffness::isFlexible, joint_stiffness::segments, joint_stiffness::flexibilityOf<double>,
                  joint_stiffness::flexibilityOf<Dual>, joint_stiffness::deflect<double, double>,
                  joint_stiffness::deflect<Dual, double>, joint_stiffness::slopesOf},
      ElementKind{"beam", "cantilever under end force, end moment and its own weight (2.8 to 2.16)",
                  ElementPlace::kMember, beam::isFlexible, beam::segments, beam::flexibilityOf<double>,
                  beam::flexibilityOf<Dual>, beam::deflect<double, double>, beam::deflect<Dual, double>,
                  beam::slopesOf},
  };
  return kKinds;
}

}  // namespace tubeplan::deflection
