#include "app/cli/command.hpp"

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
    {"add", "the cell with an effect switched on, to be fitted with the rest",
     "tubeplan add app/cells/bench.yaml backlash@tool.z --out better.yaml\n"
     "tubeplan add app/cells/bench.yaml --formula 'theta3 += c*sin(3*theta1)' --out better.yaml",
     configureAdd},
    {"effects", "the physical effects that an arm can have, their numbers, and where",
     "tubeplan effects app/cells/bench.yaml backlash", configureEffects},
    {"compare", "where the model fails, by how much, and what its error follows",
     "tubeplan compare app/cells/bench.yaml readings.csv --json comparison.json", configureCompare},
    {"diagnose", "which effect the model lacks: one, one of several, none, or none that is known",
     "tubeplan diagnose app/cells/bench.yaml readings.csv --report diagnose.html", configureDiagnose},
    {"improve", "diagnoses, adds and identifies until nothing more is shown",
     "tubeplan improve app/cells/bench.yaml readings.csv --out improved.yaml", configureImprove},
    {"ladder", "the error of one model after another, fitted and held out, against the noise floor",
     "tubeplan ladder readings.csv app/cells/bench.yaml fitted.yaml --rigid\n"
     "tubeplan ladder readings.csv app/cells/mockup.yaml fitted.yaml --truth app/cells/mockup-true.yaml",
     configureLadder},
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
    {"simulate", "measurements of a cell to practise on, with the truth beside them",
     "tubeplan simulate app/cells/bench.yaml --design bench --readings 120 --seed 1 --out out/practice\n"
     "tubeplan simulate app/cells/bowl.yaml --design bowl --readings 90 --loads 0,30 --spread 0.1 --out out/practice",
     configureSimulate},
    {"readings", "what trackers, controllers and spreadsheets wrote, as a measurement table",
     "tubeplan readings app/cells/bench.yaml points.txt joints.csv --units mm,deg --out readings.csv\n"
     "tubeplan readings app/cells/bench.yaml log.csv --column x_mm='Measured X' --column theta1_deg=Turret",
     configureReadings},
    {"touches", "which holes to touch, or postures and loads to measure, next",
     "tubeplan touches app/cells/mockup.yaml --tubes spread:60\n"
     "tubeplan touches app/cells/bench.yaml --readings readings.csv --loads 0,20,40 --count 8 --csv next.csv",
     configureTouches},
    {"sensitivity", "which member to stiffen or lighten, and which number must be known how well",
     "tubeplan sensitivity app/cells/mockup.yaml --tubes spread:60", configureSensitivity},
    {"campaign", "many calibrations or diagnoses over random truths: with what probability tools centre",
     "tubeplan campaign app/cells/mockup.yaml --runs 10000 --touches 3,6,12 --out out/campaign\n"
     "mpirun -n 64 tubeplan campaign app/cells/mockup.yaml --runs 10000000 --tubes all --out out/campaign\n"
     "tubeplan campaign app/cells/bench.yaml --kind diagnose --runs 200",
     configureCampaign},
    {"report", "a project of the workbench as a page, with what is needed to have its figures again",
     "tubeplan report bench.tubeplan --pdf bench.pdf\n"
     "tubeplan report bench.tubeplan --files out/bench",
     configureReport},
    {"serve", "the workbench: all of this in a browser, on this machine",
     "tubeplan serve app/cells/mockup.yaml\ntubeplan serve app/cells/bench.yaml readings.csv --port 0 --open",
     configureServe},
    {"arm", "arms from URDF and to it, and an arm's file shown for checking",
     "tubeplan arm import robot.urdf --out robot-arm.yaml --cell robot.yaml\n"
     "tubeplan arm show app/cells/cobra-arm.yaml --svg arm.svg",
     configureArm},
    {"completion", "a script that makes the shell complete commands and options",
     "tubeplan completion bash > ~/.local/share/bash-completion/completions/tubeplan", configureCompletion},
    {"man", "the manual page, to be shown by man", "tubeplan man > tubeplan.1 && man ./tubeplan.1", configureMan},
};

}  // namespace

std::span<const Command> commands() { return kCommands; }

}  // namespace tubeplan::app
