// The arm in its vertical plane, rigid and deflected.
import {useSignal} from "@preact/signals";
import {extentOf} from "../../../../drawing/frames.js";
import {exact, isNumber, short} from "../../../../drawing/numbers.js";
import {roundDown125} from "../../../../drawing/scales.js";
import type {ColourName} from "../../drawing/colours";
import {Select} from "../../drawing/fields";
import {MarkAt} from "../../drawing/marks";
import {choicesOf, Segments} from "../../drawing/segments";
import {Card, Lead, Legend, Missing, type OfReport} from "../parts";
import {isPoint, lengthUnit, list, points, type Report, textOf} from "../values";

type Point = [number, number];

const FACTORS = choicesOf([
  [1, "deflection ×1"],
  [10, "deflection ×10"],
] as const);

export function SideViewSection({report}: OfReport) {
  const chosen = useSignal(0),
    factor = useSignal(1);
  const views = list(report.side_views).filter(
    ({rigid, flexible}) => points(rigid).length > 1 || points(flexible).length > 1,
  );
  if (views.length === 0) return <Missing what="Side views of the arm" />;
  const view = views[chosen.value];
  return (
    <>
      <Lead>
        The arm in its own vertical plane under a tube: as a rigid arm would stand at the same joint values (dashed) and
        as it hangs under its weight (solid).
      </Lead>
      <Card title={`Under tube ${textOf(view.label, "")}`}>
        <div class="card-head">
          <Select
            label="Under tube"
            choices={views.map(({label}, value) => ({value, words: textOf(label, `View ${value + 1}`)}))}
            value={chosen.value}
            onChoose={(next) => (chosen.value = next)}
          />
          <Segments
            label="Deflection"
            choices={FACTORS}
            value={factor.value}
            onChoose={(next) => (factor.value = next)}
          />
        </div>
        <SideView report={report} view={view} factor={factor.value} />
        <Legend>
          {[
            ["side-sign rigid", "rigid"],
            ["side-sign flexible", "deflected"],
            ["side-sign body", "body as checked for clearance"],
          ]}
        </Legend>
        <p class="note">
          <Deflection view={view} factor={factor.value} unit={lengthUnit(report)} />
        </p>
      </Card>
    </>
  );
}

/** Displacement of the tip: the difference of the last points of the rigid and the deflected chain. */
function Deflection({view, factor, unit}: {view: Report; factor: number; unit: string}) {
  const rigid = points(view.rigid).at(-1),
    flexible = points(view.flexible).at(-1);
  if (!rigid || !flexible) return <>Only one of the two shapes is recorded.</>;
  const across = flexible[0] - rigid[0],
    up = flexible[1] - rigid[1];
  return (
    <>
      <b>
        The tip moves {short(Math.hypot(across, up))} {unit}
      </b>{" "}
      from the rigid to the deflected arm: {short(Math.abs(up))} {up <= 0 ? "down" : "up"} and {short(Math.abs(across))}{" "}
      {across >= 0 ? "outward (+r)" : "inward (−r)"}.{" "}
      {factor === 1
        ? "Drawn to scale."
        : `Drawn ${factor} times larger than it is, from the rigid shape: only ×1 meets the hole.`}
    </>
  );
}

/** Returns the deflected chain with its deflection multiplied by `factor`. */
function magnified(view: Report, factor: number): Point[] {
  const rigid = points(view.rigid),
    flexible = points(view.flexible);
  if (factor === 1 || rigid.length !== flexible.length) return flexible;
  const far = (i: number, k: number) => rigid[i][k] + factor * (flexible[i][k] - rigid[i][k]);
  return rigid.map((_, i) => [far(i, 0), far(i, 1)]);
}

/**
 * Returns the circle in which the arm's plane intersects the bowl, a sphere about the sheet's centre; null if the bowl
 * is unknown or not intersected.
 */
function bowlOf(report: Report, view: Report): {center: Point; radius: number} | null {
  const aside = isNumber(view.centre_aside) ? view.centre_aside : 0;
  if (!isNumber(report.bowl_radius) || report.bowl_radius <= aside) return null;
  const center: Point = isPoint(view.world_centre) ? view.world_centre : [0, 0];
  return {center, radius: Math.sqrt(report.bowl_radius ** 2 - aside ** 2)};
}

const WIDTH = 1000,
  TALLEST = 460;

/** Returns the corners of the bounding box of a capsule. */
function boxOf({from, to, radius}: Report): Point[] {
  return [from, to].flatMap(([r, z]: Point): Point[] => [-radius, radius].map((far) => [r + far, z + far]));
}

function SideView({report, view, factor}: {view: Report; factor: number} & OfReport) {
  const rigid = points(view.rigid),
    chain = magnified(view, factor),
    bowl = bowlOf(report, view);
  const bodies = list(view.shapes).filter(({from, to, radius}) => isPoint(from) && isPoint(to) && isNumber(radius));
  const [br, bz] = bowl?.center ?? [0, 0],
    around = bowl
      ? [
          [br - bowl.radius, 0],
          [br + bowl.radius, bz - bowl.radius],
        ]
      : [];
  const foot = [chain[0]?.[0] ?? 0, 0],
    hole = points([view.hole]);
  const {left, right, top, bottom} = extentOf([...rigid, ...chain, ...hole, foot, ...bodies.flatMap(boxOf), ...around]);
  const scale = Math.min((WIDTH - 70) / (right - left), TALLEST / (top - bottom)),
    height = scale * (top - bottom) + 60,
    ruler = roundDown125(0.2 * (right - left));
  const at = ([r, z]: Point): Point => [WIDTH / 2 + scale * (r - (left + right) / 2), 26 + scale * (top - z)];
  const line = (places: readonly Point[]) => `M${places.map((place) => at(place).join(" ")).join("L")}`;
  const [[x0, face], [x1]] = [at([left, 0]), at([right, 0])];
  const words = (text: string, x: number, y: number, name = "") => (
    <text class={name} x={x} y={y} text-anchor={name ? "middle" : undefined}>
      {text}
    </text>
  );
  const half = bowl ? Math.sqrt(Math.max(0, bowl.radius ** 2 - bz ** 2)) : 0,
    r = (bowl?.radius ?? 0) * scale;
  return (
    <svg class="drawing side" viewBox={`0 0 ${WIDTH} ${height}`} role="img" aria-label="The arm from the side">
      {bowl ? (
        <path class="bowl" d={`${line([[br - half, 0]])}A${r} ${r} 0 0 0 ${at([br + half, 0]).join(" ")}`} />
      ) : null}
      {bowl ? words("bowl", at(bowl.center)[0], at(bowl.center)[1] + r + 15, "middle") : null}
      <rect class="plate" x={x0} y={face - 9} width={x1 - x0} height={9} />
      <path class="face" d={`M${x0} ${face}H${x1}`} />
      {words("tube sheet", x0, face - 13)}
      {(factor === 1 ? bodies : []).map(({from, to, radius}) => (
        <path class="body" d={line([from, to])} stroke-width={2 * radius * scale} />
      ))}
      <Chain places={chain.map(at)} kind="flexible" colour="accent" />
      <Chain places={rigid.map(at)} kind="rigid" colour="case0" />
      {hole.map(at).map(([x, y]) => (
        <>
          <path class="hole-axis" d={`M${x} ${y - 9}v9`} />
          {words(textOf(view.label, "hole"), x, y - 13, "strong middle")}
        </>
      ))}
      <path class="axis" d={`M8 ${height - 13}v10M8 ${height - 8}h${ruler * scale}m0 -5v10`} />
      {words(`${exact(ruler)} ${lengthUnit(report)}`, 14 + ruler * scale, height - 4)}
    </svg>
  );
}

/** Arm as a line with its joints, and a diamond at its tip. */
function Chain({places, kind, colour}: {places: Point[]; kind: string; colour: ColourName}) {
  if (places.length < 2) return null;
  const [x, y] = places.at(-1)!;
  return (
    <>
      <polyline class={kind} points={places.join(" ")} />
      {places.slice(0, -1).map(([cx, cy]) => (
        <circle class={`${kind}-joint`} cx={cx} cy={cy} r={3} />
      ))}
      <MarkAt mark={{shape: "diamond", colour}} x={x} y={y} r={4} />
    </>
  );
}
