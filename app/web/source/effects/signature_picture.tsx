// The displacement of this arm's tip by an effect, plotted against the variable on which the effect depends.
import {plainUnit, tickTexts} from "../../../drawing/numbers.js";
import {roundTicks} from "../../../drawing/scales.js";
import type {SignatureDocument} from "../server/documents";
import {useAnswer} from "../server/answers";

const WIDTH = 420,
  HEIGHT = 150,
  LEFT = 56,
  RIGHT = 12,
  TOP = 10,
  BOTTOM = 34;

export function SignaturePicture({effect, at}: {effect: string; at: string}) {
  // Errors of this request are not shown, because the laws are useful even without the picture.
  const shown = useAnswer<SignatureDocument>(
    `/api/signature?effect=${encodeURIComponent(effect)}&at=${encodeURIComponent(at)}`,
  ).document;
  return (
    <figure class="signature">
      {shown === null ? null : shown.values.length === 0 ? (
        <p class="muted">It does not move the tip of this arm by itself.</p>
      ) : (
        <Curve document={shown} />
      )}
      <figcaption class="muted">
        Example at {at}: shift of the tip for half a typical size, over the variable that it follows most
      </figcaption>
    </figure>
  );
}

function Curve({document}: {document: SignatureDocument}) {
  const {values, shift, variable, unit, shift_unit} = document;
  const known = shift.filter((value): value is number => value !== null);
  const low = Math.min(0, ...known),
    high = Math.max(0, ...known);
  const x = (value: number) => LEFT + ((value - values[0]) / (values.at(-1)! - values[0])) * (WIDTH - LEFT - RIGHT);
  const y = (value: number) => HEIGHT - BOTTOM - ((value - low) / (high - low || 1)) * (HEIGHT - TOP - BOTTOM);
  const isTwoLevels = values.length === 2;
  let isBroken = true;
  const path = values
    .map((value, k) => {
      const at = shift[k];
      if (at === null) {
        isBroken = true;
        return "";
      }
      const step = `${isBroken ? "M" : "L"}${x(value).toFixed(1)},${y(at).toFixed(1)}`;
      isBroken = false;
      return step;
    })
    .join("");
  const ticks = roundTicks(low, high, 4),
    along = roundTicks(values[0], values.at(-1)!, 6);
  return (
    <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={`The tip's shift against ${variable}`}>
      {ticks.map((tick, k) => (
        <>
          <line class={tick === 0 ? "zero" : "grid"} x1={LEFT} x2={WIDTH - RIGHT} y1={y(tick)} y2={y(tick)} />
          <text x={LEFT - 6} y={y(tick) + 4} text-anchor="end">
            {tickTexts(ticks)[k]}
          </text>
        </>
      ))}
      {(isTwoLevels ? values : along).map((tick, k) => (
        <text x={x(tick)} y={HEIGHT - BOTTOM + 15} text-anchor="middle">
          {isTwoLevels ? (tick < 0 ? "−" : "+") : tickTexts(along)[k]}
        </text>
      ))}
      <text class="axis" x={(LEFT + WIDTH - RIGHT) / 2} y={HEIGHT - 4} text-anchor="middle">
        {variable}
        {unit === "1" ? "" : `, ${plainUnit(unit)}`}
      </text>
      <text class="axis" x={-(TOP + HEIGHT - BOTTOM) / 2} y={11} transform="rotate(-90)" text-anchor="middle">
        shift, {shift_unit}
      </text>
      <path d={path} />
      {isTwoLevels
        ? values.map((value, k) => (shift[k] === null ? null : <circle cx={x(value)} cy={y(shift[k]!)} r={4} />))
        : null}
    </svg>
  );
}
