#include "app/commands/command_table.hpp"

namespace tubeplan::app {

// Each function is defined in the source file of its command.
Run configureAdd(CLI::App& cli);
Run configureArm(CLI::App& cli);
Run configureBases(CLI::App& cli);
Run configureCalibrate(CLI::App& cli);
Run configureCampaign(CLI::App& cli);
Run configureCompare(CLI::App& cli);
Run configureCompletion(CLI::App& cli);
Run configureDiagnose(CLI::App& cli);
Run configureIdentify(CLI::App& cli);
Run configureImprove(CLI::App& cli);
Run configureJob(CLI::App& cli);
Run configureLadder(CLI::App& cli);
Run configureMan(CLI::App& cli);
Run configureMap(CLI::App& cli);
Run configureEffects(CLI::App& cli);
Run configurePlan(CLI::App& cli);
Run configurePose(CLI::App& cli);
Run configureMeasurements(CLI::App& cli);
Run configureReport(CLI::App& cli);
Run configureScore(CLI::App& cli);
Run configureSimulate(CLI::App& cli);
Run configureSensitivity(CLI::App& cli);
Run configureServe(CLI::App& cli);
Run configureTouches(CLI::App& cli);
Run configureVerify(CLI::App& cli);
Run configureWatch(CLI::App& cli);

namespace {

constexpr Command kCommands[] = {
    {"pose", "tip pose of the rigid and of the deflected arm",
     "tubeplan pose app/cells/bench.yaml --joints=-36.688,46.138,-35.856,-11.127 --load 30", configurePose},
    {"map", "the holes of a cell's tube sheet", "tubeplan map app/cells/mockup.yaml --csv holes.csv", configureMap},
    {"calibrate", "base pose from three or more touched holes",
     "tubeplan calibrate app/cells/mockup.yaml touches.csv --out calibrated.yaml", configureCalibrate},
    {"identify", "identifies the model's parameters and the base pose from measurements",
     "tubeplan identify app/cells/bench.yaml readings.csv --out fitted.yaml\n"
     "tubeplan identify cell.yaml readings.csv --free tool.tip,geometry",
     configureIdentify},
    {"add", "adds an effect to the cell, to be identified with its other parameters",
     "tubeplan add app/cells/bench.yaml backlash@tool.z --out better.yaml\n"
     "tubeplan add app/cells/bench.yaml --formula 'theta3 += c*sin(3*theta1)' --out better.yaml",
     configureAdd},
    {"effects", "the physical effects that an arm can have: laws, parameters, places",
     "tubeplan effects app/cells/bench.yaml backlash", configureEffects},
    {"compare", "compares the model with measurements: how large its error is, and what it depends on",
     "tubeplan compare app/cells/bench.yaml readings.csv --json comparison.json", configureCompare},
    {"diagnose", "finds the missing physical effect: one, one of several, none, or an unknown one",
     "tubeplan diagnose app/cells/bench.yaml readings.csv --report diagnose.html", configureDiagnose},
    {"improve", "diagnoses, adds and identifies until no further effect is found",
     "tubeplan improve app/cells/bench.yaml readings.csv --out improved.yaml", configureImprove},
    {"ladder", "compares models: fitted and held-out error of each against the noise floor",
     "tubeplan ladder readings.csv app/cells/bench.yaml fitted.yaml --rigid\n"
     "tubeplan ladder readings.csv app/cells/mockup.yaml fitted.yaml --truth app/cells/mockup-true.yaml",
     configureLadder},
    {"plan", "plans a collision-free, timed path to a list of tubes",
     "tubeplan plan app/cells/mockup.yaml --tubes spread:60 --touches auto --truth app/cells/mockup-true.yaml --seed 1 "
     "--out out/plan",
     configurePlan},
    {"bases", "chooses base positions: the few from which most tubes are reached, and the fewest that reach all",
     "tubeplan bases app/cells/mockup.yaml --tubes spread:100 --along x=-20:20:5 --along y=35:50:4 --most 2",
     configureBases},
    {"verify", "verifies a plan by code independent of the planner", "tubeplan verify app/cells/mockup.yaml out/plan",
     configureVerify},
    {"score", "centring error and inserted steps of the true arm, with and without compensation",
     "tubeplan score app/cells/mockup.yaml --truth app/cells/mockup-true.yaml --tubes spread:60\n"
     "tubeplan score app/cells/mockup.yaml --truth app/cells/mockup.yaml --runs 100",
     configureScore},
    {"simulate", "simulates measurements of a cell, with the ground truth in a file of its own",
     "tubeplan simulate app/cells/bench.yaml --design bench --readings 120 --seed 1 --out out/practice\n"
     "tubeplan simulate app/cells/bowl.yaml --design bowl --readings 90 --loads 0,30 --spread 0.1 --out out/practice",
     configureSimulate},
    {"readings", "converts files of trackers, controllers and spreadsheets to a measurement table",
     "tubeplan readings app/cells/bench.yaml points.txt joints.csv --units mm,deg --out readings.csv\n"
     "tubeplan readings app/cells/bench.yaml log.csv --column x_mm='Measured X' --column theta1_deg=Turret",
     configureMeasurements},
    {"touches", "chooses the next holes to touch, or postures and loads to measure",
     "tubeplan touches app/cells/mockup.yaml --tubes spread:60\n"
     "tubeplan touches app/cells/bench.yaml --readings readings.csv --loads 0,20,40 --count 8 --csv next.csv",
     configureTouches},
    {"sensitivity", "which member to stiffen or lighten, and how accurately each parameter must be known",
     "tubeplan sensitivity app/cells/mockup.yaml --tubes spread:60", configureSensitivity},
    {"campaign", "Monte Carlo study: many calibrations, diagnoses or outages of randomly drawn true arms",
     "tubeplan campaign app/cells/mockup.yaml --runs 10000 --touches 3,6,12 --out out/campaign\n"
     "mpirun -n 64 tubeplan campaign app/cells/mockup.yaml --runs 10000000 --tubes all --out out/campaign\n"
     "tubeplan campaign app/cells/bench.yaml --kind diagnose --runs 200",
     configureCampaign},
    {"watch", "watches the readings of a calibrated arm at work: detects when the model became wrong, and what changed",
     "tubeplan watch calibrated.yaml visits.csv --planned 4674", configureWatch},
    {"report", "writes a report of a workbench project, with everything that reproduces its figures",
     "tubeplan report bench.tubeplan --pdf bench.pdf\n"
     "tubeplan report bench.tubeplan --files out/bench",
     configureReport},
    {"serve", "the workbench: the same functions in a browser, on this machine",
     "tubeplan serve app/cells/mockup.yaml\ntubeplan serve app/cells/bench.yaml readings.csv --port 0 --open",
     configureServe},
    {"job", "the work of an outage: its tubes, their results, and the next visit",
     "tubeplan job create app/cells/outage/job.yaml --out spring.job\n"
     "tubeplan job plan spring.job --out out/spring\n"
     "tubeplan job next spring.job --sg A --leg hot\n"
     "tubeplan job confirm spring.job A/hot/R12C40 --position=-18.594,13.967 --by camera\n"
     "tubeplan job mark spring.job A/hot/R12C40 --as done --by Tom\n"
     "tubeplan job status spring.job\n"
     "tubeplan job report spring.job --out handover.html",
     configureJob},
    {"arm",
     "imports arms from URDF or a controller, exports them by any convention, and shows an arm file for checking",
     "tubeplan arm import robot.urdf --out robot-arm.yaml --cell robot.yaml\n"
     "tubeplan arm import calibration.conf --nominal nominal-arm.yaml --out robot-arm.yaml\n"
     "tubeplan arm import my_robot_calibration.yaml --nominal robot-arm.yaml --out calibrated-arm.yaml\n"
     "tubeplan arm export app/cells/iiwa-arm.yaml --convention standard --out iiwa-standard.yaml\n"
     "tubeplan arm export robot-arm.yaml --into robot.urdf --out calibrated.urdf\n"
     "tubeplan arm show app/cells/cobra-arm.yaml --svg arm.svg",
     configureArm},
    {"completion", "writes a shell completion script",
     "tubeplan completion bash > ~/.local/share/bash-completion/completions/tubeplan", configureCompletion},
    {"man", "writes the manual page", "tubeplan man > tubeplan.1 && man ./tubeplan.1", configureMan},
};

}  // namespace

std::span<const Command> commands() { return kCommands; }

}  // namespace tubeplan::app
