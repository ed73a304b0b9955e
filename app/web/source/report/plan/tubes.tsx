// The results of all visited tubes, and the work list: the tubes in visiting order as a printable sheet to tick off at
// the arm. Both are rendered only on request.
import {useSignal} from "@preact/signals";
import {useRef} from "preact/hooks";
import {render} from "preact";
import {fixed, isNumber, plural, probability, short, whole} from "../../../../drawing/numbers.js";
import {stepCountOf, stepMark, stepText} from "../../../../drawing/steps.js";
import {MarkIcon} from "../../drawing/marks";
import {Missing, type OfReport, PrintButton, Table} from "../parts";
import {angleUnit, lengthUnit, list, object, type Report, textOf, tubeName} from "../values";
import {chancesOf, type Mode, modesOf} from "./cases";

export function TubesSection({report}: OfReport) {
  const isOpen = useSignal(false),
    count = list(report.tubes).length;
  if (count === 0) return <Missing what="Visited tubes" />;
  return (
    <details class="card" onToggle={(event) => (isOpen.value ||= event.currentTarget.open)}>
      <summary>Figures of {plural(count, "visited tube")}</summary>
      {isOpen.value ? <TubeTable report={report} /> : null}
    </details>
  );
}

function TubeTable({report}: OfReport) {
  const unit = lengthUnit(report),
    modes = modesOf(report);
  const rows = list(report.tubes).map((tube, i) => [
    whole(i + 1),
    tubeName(tube),
    fixed(tube.x, 3),
    fixed(tube.y, 3),
    short(tube.tilt),
    short(tube.predicted_error),
    probability(chancesOf(tube, report)?.at(-1)),
    ...modes.map((mode) => <Score report={report} tube={tube} mode={mode} />),
  ]);
  const heads = [
    "visit",
    "tube",
    `x, ${unit}`,
    `y, ${unit}`,
    `tilt, ${angleUnit(report)}`,
    `predicted error, ${unit}`,
    `probability that ${stepText(report.step_words, stepCountOf(report))}`,
    ...modes.map(({brief}) => `error, ${unit}, and steps: ${brief}`),
  ];
  return <Table heads={heads} rows={rows} text={[1]} />;
}

/** Table cell with the centring error and the number of steps that enter. */
function Score({report, tube, mode}: {tube: Report; mode: Mode} & OfReport) {
  const steps = mode.caseOf(tube);
  if (steps === null) return <>–</>;
  return (
    <>
      {short(object(tube[mode.key])?.error)}&nbsp;&nbsp;
      <MarkIcon mark={stepMark(steps, stepCountOf(report), object(report.base))} /> {steps}
    </>
  );
}

// ---- the work list

export function WorkListSection({report}: OfReport) {
  const card = useRef<HTMLDetailsElement>(null),
    place = useRef<HTMLDivElement>(null);
  const count = list(report.tubes).length;
  if (count === 0) return <Missing what="The work list" />;
  // Renders synchronously, because the printer prints the current content.
  const show = () => render(<WorkList report={report} />, place.current!);
  const prepare = () => {
    show();
    card.current!.open = true;
  };
  return (
    <>
      <PrintButton prepare={prepare}>Print the list alone</PrintButton>
      <details class="card" ref={card} onToggle={show}>
        <summary>Work list of {plural(count, "tube")}, to print</summary>
        <div ref={place} />
      </details>
    </>
  );
}

/**
 * Work list with leg, row and column in every line. Tubes that cannot be visited follow at the end, with the reason.
 */
function WorkList({report}: OfReport) {
  const sheet = object(report.sheet) ?? {},
    leg = textOf(sheet.leg, ""),
    tubes = list(report.tubes),
    missed = list(report.unreachable);
  const of = [sheet.name, sheet.leg_words, sheet.view_words, `sheet ${textOf(sheet.fingerprint)}`];
  const rows = tubes.map((tube, i) => [
    "☐",
    whole(i + 1),
    `${leg} ${tubeName(tube)}`,
    isNumber(tube.dwell_s) ? short(tube.dwell_s) : "",
    "",
  ]);
  return (
    <>
      <p>
        {[...of, plural(tubes.length, "tube")].map((text) => textOf(text, "")).join(" · ")} · signed
        ____________________ date ____________
      </p>
      <Table heads={["done", "visit", "tube", "stay, s", "remark"]} rows={rows} text={[0, 2, 4]} />
      {missed.length > 0 ? (
        <>
          <p>{plural(missed.length, "tube")} cannot be visited:</p>
          <Table
            heads={["tube", "reason"]}
            rows={missed.map((tube) => [`${leg} ${tubeName(tube)}`, textOf(tube.reason, "")])}
            text={[0, 1]}
          />
        </>
      ) : null}
    </>
  );
}
