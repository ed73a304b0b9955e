// Writing figures: real minus signs, about three figures, never more digits than sigma tells.

export const MISSING = "–";

export function isNumber(value: unknown): value is number {
  return typeof value === "number" && Number.isFinite(value);
}

export function fixed(value: unknown, digits: number): string {
  if (!isNumber(value)) return MISSING;
  return value.toLocaleString("en", {minimumFractionDigits: digits, maximumFractionDigits: digits}).replace("-", "−");
}

/** About three figures: 0.0302, 12.4, 4,674, 3.1e−8. */
export function short(value: unknown): string {
  if (!isNumber(value)) return MISSING;
  const size = Math.abs(value);
  if (size === 0) return "0";
  if (size < 5e-4 || size >= 1e6)
    return value
      .toExponential(size < 1 ? 1 : 2)
      .replace("e-", "e−")
      .replace("e+", "e")
      .replace(/^-/, "−");
  const digits = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : size >= 0.1 ? 3 : 4;
  return fixed(value, digits);
}

/** As it was given, to six figures. */
export function exact(value: unknown): string {
  return isNumber(value) ? value.toLocaleString("en", {maximumSignificantDigits: 6}).replace("-", "−") : MISSING;
}

export function whole(value: unknown): string {
  return fixed(value, 0);
}

export function percent(fraction: unknown, digits = 0): string {
  return isNumber(fraction) ? `${fixed(100 * fraction, digits)} %` : MISSING;
}

/** Certainty is said only where it is certain. */
export function probability(value: unknown): string {
  if (!isNumber(value)) return MISSING;
  if (value > 0 && value < 0.001) return "< 0.1 %";
  if (value < 1 && value > 0.999) return "> 99.9 %";
  return percent(value, 1);
}

/** A p-value: p = 0.032, p = 6e−173. */
export function chance(p: number | null | undefined): string {
  if (!isNumber(p)) return "not tested";
  if (p < 1e-300) return "p < 1e−300";
  return p < 0.001 ? `p = ${p.toExponential(0).replace("e-", "e−")}` : `p = ${fixed(p, p < 0.095 ? 3 : 2)}`;
}

export function duration(seconds: unknown): string {
  if (!isNumber(seconds)) return MISSING;
  if (seconds < 120) return `${fixed(seconds, seconds < 10 ? 1 : 0)} s`;
  const total = Math.round(seconds);
  const two = (value: number) => String(value).padStart(2, "0");
  if (total < 7200) return `${Math.floor(total / 60)} min ${two(total % 60)} s`;
  return `${Math.floor(total / 3600)} h ${two(Math.round((total % 3600) / 60))} min`;
}

/** A clock of fixed width: 03:07.5. */
export function clock(seconds: number): string {
  const minutes = Math.floor(seconds / 60);
  return `${String(minutes).padStart(2, "0")}:${(seconds - 60 * minutes).toFixed(1).padStart(4, "0")}`;
}

export function plural(count: number, one: string, many = `${one}s`): string {
  return `${whole(count)} ${count === 1 ? one : many}`;
}

export function unitText(unit: string | undefined): string {
  return !unit || unit === "1" ? "" : ` ${unit.replace("degree", "deg")}`;
}

/** A value with as many digits as its sigma tells, sigma with two: 0.1101 ± 0.0007 deg, (9.93 ± 0.07)e6 lbf/in^2. */
export function withSigma(value: number, sigma: number | null | undefined, unit?: string): string {
  if (!isNumber(value) || !isNumber(sigma) || sigma <= 0) return `${short(value)}${unitText(unit)}`;
  const {value: shown, sigma: about, power} = pairOf(value, sigma);
  const pair = `${shown} ± ${about}`;
  return `${power === "" ? pair : `(${pair})${power}`}${unitText(unit)}`;
}

/** The two of withSigma by themselves, for a table. */
export function valueAndSigma(value: number, sigma: number | null | undefined): [string, string] {
  if (!isNumber(value) || !isNumber(sigma) || sigma <= 0) return [short(value), MISSING];
  const {value: shown, sigma: about, power} = pairOf(value, sigma);
  return [shown + power, about + power];
}

/** Figures beyond these are written with a power of ten. */
const LARGEST = 1e5,
  SMALLEST = 1e-3;

function pairOf(value: number, sigma: number): {value: string; sigma: string; power: string} {
  const size = Math.max(Math.abs(value), sigma);
  const exponent = size >= LARGEST || size < SMALLEST ? Math.floor(Math.log10(size) + 1e-12) : 0;
  const scale = 10 ** exponent;
  const digits = Math.max(0, Math.min(9, 1 - Math.floor(Math.log10(sigma / scale))));
  const step = 10 ** Math.max(0, Math.floor(Math.log10(sigma / scale)) - 1);
  const rounded = (number: number) => fixed(Math.round(number / scale / step) * step, digits);
  const roundedFine = (number: number) => fixed(number / scale, digits);
  const written = step > 1 ? rounded : roundedFine;
  return {
    value: written(value),
    sigma: written(sigma),
    power: exponent === 0 ? "" : `e${String(exponent).replace("-", "−")}`,
  };
}

/** The 1, 2 or 5 times a power of ten at or below a positive value. */
export function roundDown125(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  const step = [5, 2, 1].find((factor) => factor * power <= value * (1 + 1e-9)) ?? 1;
  return Number((step * power).toPrecision(1));
}

/** Round values from `low` to `high`, about `count` of them. */
export function roundTicks(low: number, high: number, count: number): number[] {
  if (!(high > low)) return [low];
  const step =
    [1, 2, 5, 10]
      .map((factor) => factor * roundDown125((high - low) / Math.max(1, count)))
      .find((candidate) => (high - low) / candidate <= count + 0.5) ?? high - low;
  const ticks: number[] = [];
  for (let value = Math.ceil(low / step - 1e-9) * step; value <= high + 1e-9 * step; value += step) {
    ticks.push(Number(value.toPrecision(12)));
  }
  return ticks;
}
