// The arm in its vertical plane, rigid and deflected.
import {useSignal} from "@preact/signals";
import {extentOf, type Extent} from "../../../../drawing/frames.js";
import {exact, isNumber, short} from "../../../../drawing/numbers.js";
import {roundDown125} from "../../../../drawing/scales.js";
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
          <select aria-label="Under tube" onChange={(event) => (chosen.value = Number(event.currentTarget.value))}>
            {views.map(({label}, i) => (
              <option value={i}>{textOf(label, `View ${i + 1}`)}</option>
            ))}
          </select>
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

/** How far the tip moves, from the last points of the two chains. */
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

/** The deflected chain with its deflection magnified. */
function magnified(view: Report, factor: number): Point[] {
  const rigid = points(view.rigid),
    flexible = points(view.flexible);
  if (factor === 1 || rigid.length !== flexible.length) return flexible;
  const far = (i: number, k: number) => rigid[i][k] + factor * (flexible[i][k] - rigid[i][k]);
  return rigid.map((_, i) => [far(i, 0), far(i, 1)]);
}

/** The circle in which the arm's plane cuts the bowl, a sphere about the sheet's centre; null when it is not known. */
function bowlOf(report: Report, view: Report): {center: Point; radius: number} | null {
  const aside = isNumber(view.centre_aside) ? view.centre_aside : 0;
  if (!isNumber(report.bowl_radius) || report.bowl_radius <= aside) return null;
  const center: Point = isPoint(view.world_centre) ? view.world_centre : [0, 0];
  return {center, radius: Math.sqrt(report.bowl_radius ** 2 - aside ** 2)};
}

const WIDTH = 1000,
  TALLEST = 460;

function SideView({report, view, factor}: {view: Report; factor: number} & OfReport) {
  const rigid = points(view.rigid),
    chain = magnified(view, factor),
    bowl = bowlOf(report, view);
  const bodies = list(view.shapes).filter(({from, to, radius}) => isPoint(from) && isPoint(to) && isNumber(radius));
  const extent = extentOf([
    ...rigid,
    ...chain,
    ...points([view.hole]),
    [chain[0]?.[0] ?? 0, 0],
    ...bodies.flatMap(({from, to, radius}) =>
      [from, to].flatMap(([r, z]: Point) => [
        [r - radius, z - radius],
        [r + radius, z + radius],
      ]),
    ),
    ...(bowl
      ? [
          [bowl.center[0] - bowl.radius, 0],
          [bowl.center[0] + bowl.radius, bowl.center[1] - bowl.radius],
        ]
      : []),
  ]);
  const {left, right, top, bottom} = extent;
  const scale = Math.min((WIDTH - 70) / (right - left), TALLEST / (top - bottom)),
    height = scale * (top - bottom) + 60;
  const at = ([r, z]: Point): Point => [WIDTH / 2 + scale * (r - (left + right) / 2), 26 + scale * (top - z)];
  return (
    <svg
      class="drawing side"
      viewBox={`0 0 ${WIDTH} ${height}`}
      role="img"
      aria-label="The arm from the side, rigid and deflected"
    >
      {bowl ? <Bowl {...bowl} at={at} scale={scale} /> : null}
      <SheetFace extent={extent} at={at} />
      {factor === 1
        ? bodies.map(({from, to, radius}) => (
            <path class="body" d={lineOf([from, to], at)} stroke-width={2 * radius * scale} />
          ))
        : null}
      <Chain chain={chain} at={at} kind="flexible" />
      <Chain chain={rigid} at={at} kind="rigid" />
      {isPoint(view.hole) ? <Hole view={view} at={at(view.hole)} /> : null}
      <Ruler length={roundDown125(0.2 * (right - left))} scale={scale} y={height - 8} unit={lengthUnit(report)} />
    </svg>
  );
}

type At = (point: Point) => Point;

const lineOf = (chain: readonly Point[], at: At) => `M${chain.map((point) => at(point).join(" ")).join("L")}`;

function Bowl({center, radius, at, scale}: {center: Point; radius: number; at: At; scale: number}) {
  const half = Math.sqrt(Math.max(0, radius * radius - center[1] * center[1])),
    r = radius * scale;
  const [x, y] = at([center[0], center[1] - radius]);
  return (
    <>
      <path
        class="bowl"
        d={`M${at([center[0] - half, 0]).join(" ")}A${r} ${r} 0 0 0 ${at([center[0] + half, 0]).join(" ")}`}
      />
      <text x={x} y={y + 15} text-anchor="middle">
        bowl
      </text>
    </>
  );
}

function SheetFace({extent, at}: {extent: Extent; at: At}) {
  const [x, y] = at([extent.left, 0]),
    [end] = at([extent.right, 0]);
  return (
    <>
      <rect class="plate" x={x} y={y - 9} width={end - x} height={9} />
      <path class="face" d={`M${x} ${y}H${end}`} />
      <text x={x} y={y - 13}>
        tube sheet
      </text>
    </>
  );
}

function Chain({chain, at, kind}: {chain: readonly Point[]; at: At; kind: "rigid" | "flexible"}) {
  if (chain.length < 2) return null;
  const [x, y] = at(chain.at(-1)!);
  return (
    <>
      <path class={kind} d={lineOf(chain, at)} />
      {chain.slice(0, -1).map((point) => {
        const [cx, cy] = at(point);
        return <circle class={`${kind}-joint`} cx={cx} cy={cy} r={3} />;
      })}
      <MarkAt mark={{shape: "diamond", colour: kind === "rigid" ? "case0" : "accent"}} x={x} y={y} r={4} />
    </>
  );
}

function Hole({view, at: [x, y]}: {view: Report; at: Point}) {
  return (
    <>
      <path class="hole-axis" d={`M${x} ${y - 9}v9`} />
      <text class="strong" x={x} y={y - 13} text-anchor="middle">
        {textOf(view.label, "hole")}
      </text>
    </>
  );
}

/** A round length in the lower left corner. */
function Ruler({length, scale, y, unit}: {length: number; scale: number; y: number; unit: string}) {
  return (
    <>
      <path class="axis" d={`M8 ${y - 5}v10M8 ${y}h${length * scale}m0 -5v10`} />
      <text x={14 + length * scale} y={y + 4}>
        {exact(length)} {unit}
      </text>
    </>
  );
}
