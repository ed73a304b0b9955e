#include "app/command.hpp"

namespace tubeplan::app {

namespace {

constexpr Command kCommands[] = {
    {"pose", "where the tip is, rigid and deflected",
     "tubeplan pose app/cells/bench.yaml --joints=-36.688,46.138,-35.856,-11.127 --load 30", configurePose},
    {"map", "the holes of a cell's tube sheet", "tubeplan map app/cells/mockup.yaml --csv holes.csv", configureMap},
    {"calibrate", "where the base stands, from three or more touched holes",
     "tubeplan calibrate app/cells/mockup.yaml touches.csv --out calibrated.yaml", configureCalibrate},
    {"identify", "the model's parameters, and the base, from measurements",
     "tubeplan identify app/cells/bench.yaml readings.csv --out fitted.yaml\n"
     "tubeplan identify cell.yaml readings.csv --free tool.tip,geometry",
     configureIdentify},
    {"compare", "where the model fails, by how much, and what its error follows",
     "tubeplan compare app/cells/bench.yaml readings.csv --json comparison.json", configureCompare},
    {"diagnose", "which effect the model lacks: one, one of several, none, or none that is known",
     "tubeplan diagnose app/cells/bench.yaml readings.csv --report diagnose.html", configureDiagnose},
    {"plan", "a proved, timed visit of a list of tubes",
     "tubeplan plan app/cells/mockup.yaml --tubes spread:60 --touches auto --truth app/cells/mockup-true.yaml --seed 1 "
     "--out out/demo",
     configurePlan},
    {"verify", "proves a plan again, by other code than made it", "tubeplan verify app/cells/mockup.yaml out/demo",
     configureVerify},
    {"score", "centring and steps inserted by the true arm, with and without compensation",
     "tubeplan score app/cells/mockup.yaml --truth app/cells/mockup-true.yaml --tubes spread:60\n"
     "tubeplan score app/cells/mockup.yaml --truth app/cells/mockup.yaml --runs 100",
     configureScore},
};

}  // namespace

std::span<const Command> commands() { return kCommands; }

}  // namespace tubeplan::app
