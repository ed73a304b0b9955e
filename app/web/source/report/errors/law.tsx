// The errors expressed as errors of the quantity on which a cause acts, plotted against the variable of its law, with
// the law as a line.
import {useMemo} from "preact/hooks";
import {explanationTitle} from "../../../../drawing/explanations.js";
import {multiplesOf, loudest, multiplesScale} from "../../../../drawing/joint_multiples.js";
import {plainUnit, short} from "../../../../drawing/numbers.js";
import type {View} from "../../../../drawing/own_variable.js";
import {commonMost, letterOf, type ErrorPair} from "../../../../drawing/reading_errors.js";
import {MOST_MARKS} from "../../../../drawing/shares.js";
import {JointGrid} from "../../error/joint_grid";
import {SeriesLegend} from "../../error/series_legend";
import {Card, Lead, Missing, type OfReport} from "../parts";
import {list} from "../values";
import {ErrorPlotBox} from "./error_plot_box";
import {errorsOf, lawViewOf} from "./pairs";

export function LawSection({report}: OfReport) {
  const plots = useMemo(() => {
    const {pairs, axes} = errorsOf(report);
    return pairs.flatMap((pair): [ErrorPair, View][] => {
      const view = pair.readings.length > 0 ? lawViewOf(report, pair, axes) : null;
      return view ? [[pair, view]] : [];
    });
  }, [report]);
  if (plots.length === 0) return <Lead>The errors follow no variable of the readings.</Lead>;
  const most = plots.length > 1 ? commonMost(...plots) : null;
  return (
    <>
      <Lead>{leadOf(plots)}</Lead>
      <LawLegend errors={plots[0][0]} hasLaw={plots.some(([pair]) => pair.causes.length > 0)} />
      <div class={plots.length > 1 ? "pair" : ""}>
        {plots.map(([errors, view], k) => (
          <Card title={headingOf(errors, plots.length > 1 ? letterOf(k) : "")}>
            <ErrorPlotBox report={report} errors={errors} view={view} most={most} />
          </Card>
        ))}
      </div>
    </>
  );
}

function headingOf({causes}: ErrorPair, letter: string): string {
  const title = causes.length > 0 ? explanationTitle({effects: causes as {effect: string; at: string}[]}) : "";
  return [letter, title].filter((text) => text !== "").join(": ");
}

function leadOf(plots: [ErrorPair, View][]): string {
  if (!plots.some(([pair]) => pair.causes.length > 0))
    return "The errors against what they follow most, with means of bins.";
  return (
    `${plots.length > 1 ? "Each explanation" : "The cause"} is drawn against the variable that its law depends on, and as ` +
    "the error that it would explain. The line is the law, its band the spread of what it does there. Where the law is " +
    "right the means before lie on it, and those after lie at zero."
  );
}

function LawLegend({errors, hasLaw}: {errors: ErrorPair; hasLaw: boolean}) {
  return (
    <SeriesLegend errors={errors} isBrief most={MOST_MARKS}>
      <span>
        <i class="means-sign" /> means {errors.judged === 0 ? "before" : "after"}, two standard errors to both sides
      </span>
      {hasLaw ? (
        <span>
          <i class="law-sign" /> law and its spread
        </span>
      ) : null}
    </SeriesLegend>
  );
}

/** Shows the errors of each joint against its angle, its direction of motion, its moment and the load. */
export function JointsSection({report}: OfReport) {
  const {errors, multiples} = useMemo(() => {
    const {pairs, axes} = errorsOf(report),
      [errors] = pairs,
      rows = new Map(list(report.joints).map(({name, row}) => [name, row ?? ""]));
    const rowOf = (joint: string) => rows.get(joint) ?? "";
    const tested = list(report.tested) as any;
    return {errors, multiples: multiplesOf({errors, ...axes, tested, rowOf})};
  }, [report]);
  if (multiples.length === 0) return <Missing what="The errors joint by joint" />;
  return (
    <>
      <Lead>
        The error expressed as an error of each joint, against the joint's angle, its direction of approach, the moment
        about it and the load, all to one scale of ±{short(multiplesScale(multiples, errors))}{" "}
        {plainUnit(multiples[0].part.unit)}; larger errors are drawn at its edge. The p-value of each variable is
        corrected for the number of tests;{" "}
        {loudest(multiples) ? "the most significant is framed" : "none is below 0.01"}.
      </Lead>
      <Card>
        <JointGrid errors={errors} multiples={multiples} />
      </Card>
    </>
  );
}
