// The correlations of a covariance as squares: the size shows the magnitude, colour and shape show the sign.
import {fixed} from "../../../drawing/numbers.js";

const NAMES = ["x", "y", "z", "about x", "about y", "about z"];

export function correlations(matrix: number[][]): number[][] {
  return matrix.map((row, i) => row.map((value, j) => value / Math.sqrt(matrix[i][i] * matrix[j][j])));
}

export function Covariance({matrix}: {matrix: number[][]}) {
  if (!matrix || matrix.length !== 6) return null;
  const values = correlations(matrix),
    side = 26,
    left = 58;
  return (
    <svg
      class="covariance"
      viewBox={`0 0 ${left + 6 * side} ${6 * side + 2}`}
      role="img"
      aria-label="Correlations of the base's six numbers"
    >
      {values.map((row, i) => (
        <g key={i}>
          <text x={left - 6} y={side * (i + 0.5) + 4} text-anchor="end">
            {NAMES[i]}
          </text>
          {row.slice(0, i + 1).map((value, j) => {
            const x = left + side * (j + 0.5),
              y = side * (i + 0.5),
              r = Math.sqrt(Math.abs(value)) * (side / 2 - 2);
            return (
              <g>
                <rect class="cell" x={left + side * j} y={side * i} width={side} height={side} />
                {value >= 0 ? (
                  <rect class="positive" x={x - r} y={y - r} width={2 * r} height={2 * r} />
                ) : (
                  <circle class="negative" cx={x} cy={y} r={r} />
                )}
                <title>{`${NAMES[i]} and ${NAMES[j]}: ${fixed(value, 2)}`}</title>
              </g>
            );
          })}
        </g>
      ))}
    </svg>
  );
}
