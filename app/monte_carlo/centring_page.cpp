#include "app/monte_carlo/centring_figures.hpp"

namespace tubeplan::app {

std::string centringPage(const CentringResults&, const nlohmann::json& figures) { return figures.dump(); }

}  // namespace tubeplan::app
