// The posterior plotted against the number of readings: a line for each explanation, with its name and current value at
// the end.
import {MISSING, probability} from "../../../drawing/numbers.js";
import {posteriorHistory} from "./posterior_history";

const WIDTH = 460,
  HEIGHT = 100,
  LEFT = 34,
  RIGHT = 200,
  TOP = 8,
  BOTTOM = 20;
const NAME_HEIGHT = 13;

export function PosteriorPicture() {
  const history = posteriorHistory.value;
  if (!history) return null;
  const {steps, titles} = history;
  const first = steps[0].readings,
    last = steps.at(-1)!.readings;
  const x = (readings: number) => LEFT + ((readings - first) / (last - first)) * (WIDTH - LEFT - RIGHT);
  const y = (share: number) => HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM);
  const of = (title: string, k: number) => steps[k].of[title] ?? 0;
  const now = titles.map((title) => of(title, steps.length - 1));
  // Names are stacked without overlap, each as close to the end of its line as possible.
  let free = 0;
  const names = now.map((share) => (free = Math.max(free + NAME_HEIGHT, y(share) + 4)));
  return (
    <figure class="posterior">
      <figcaption class="muted">Probability of each explanation, reading after reading</figcaption>
      <svg
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        role="img"
        aria-label={titles.map((title, k) => `${title} ${probability(now[k])}`).join("; ")}
      >
        {[0, 0.5, 1].map((share) => (
          <g key={share}>
            <line class="grid" x1={LEFT} x2={WIDTH - RIGHT} y1={y(share)} y2={y(share)} />
            <text x={LEFT - 5} y={y(share) + 4} text-anchor="end">
              {100 * share}
            </text>
          </g>
        ))}
        <text x={LEFT} y={HEIGHT - 5}>
          {first} readings
        </text>
        <text x={WIDTH - RIGHT} y={HEIGHT - 5} text-anchor="end">
          {last}
        </text>
        {titles.map((title, k) => (
          <g key={title} class={`series${k}`}>
            <polyline
              points={steps.map(({readings}, s) => `${x(readings).toFixed(1)},${y(of(title, s)).toFixed(1)}`).join(" ")}
            />
            <circle cx={x(last)} cy={y(now[k])} r={2.5} />
            <text x={WIDTH - RIGHT + 8} y={Math.min(names[k], HEIGHT)}>
              {title in steps.at(-1)!.of ? probability(now[k]) : MISSING}{" "}
              {title.length > 26 ? `${title.slice(0, 25)}…` : title}
              <title>{title}</title>
            </text>
          </g>
        ))}
      </svg>
    </figure>
  );
}
