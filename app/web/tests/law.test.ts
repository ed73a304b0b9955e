// Tests of the law of a cause as a curve.
import {describe, expect, it} from "vitest";
import {lawCurve} from "../../drawing/law.js";

const COUNT = 80;
const wave = (k: number) => ((k * 0.618034) % 1) * 2 - 1;
const xs = Array.from({length: COUNT}, (_, k) => 90 * wave(k));
const scatter = (k: number) => 0.02 * wave(3 * k + 1);

describe("the law of a cause", () => {
  it("is a straight line where the contributions are proportional to the variable", () => {
    const law = lawCurve(
      xs,
      xs.map((x, k) => 0.01 * x + scatter(k)),
      "",
    );
    expect(law).toHaveLength(2);
    expect((law[1].mean - law[0].mean) / (law[1].x - law[0].x)).toBeCloseTo(0.01, 3);
  });

  it("is a wave of two periods in a turn where they follow it", () => {
    const of = (x: number) => Math.sin((2 * x * Math.PI) / 180);
    const law = lawCurve(
      xs,
      xs.map((x, k) => of(x) + scatter(k)),
      "deg",
    );
    for (const {x, mean} of law) expect(mean).toBeCloseTo(of(x), 1);
  });

  it("is a wave where they follow sine and cosine of a joint, in degrees or radians", () => {
    for (const [unit, factor] of [
      ["deg", Math.PI / 180],
      ["rad", 1],
    ] as const) {
      const own = xs.map((x) => (x / 180) * (Math.PI / factor));
      const law = lawCurve(
        own,
        own.map((x, k) => 0.5 * Math.sin(factor * x) + 0.2 * Math.cos(factor * x) + scatter(k)),
        unit,
      );
      expect(law.length).toBeGreaterThan(40);
      const middle = law[Math.floor(law.length / 2)];
      expect(middle.mean).toBeCloseTo(0.5 * Math.sin(factor * middle.x) + 0.2 * Math.cos(factor * middle.x), 1);
    }
  });

  it("is a smooth curve where neither describes it", () => {
    const of = (x: number) => Math.sin(0.1 * x);
    const law = lawCurve(
      xs,
      xs.map((x, k) => of(x) + scatter(k)),
      "deg",
    );
    expect(law.length).toBeGreaterThan(100);
    const turns = law.slice(2).filter(({mean}, k) => {
      const [first, second] = [law[k].mean, law[k + 1].mean];
      return (second - first) * (mean - second) < 0;
    });
    expect(turns.length).toBeLessThan(8); // six of the wave itself
    for (const {x, mean, spread} of law) {
      expect(Math.abs(mean - of(x))).toBeLessThan(0.3);
      expect(spread).toBeLessThan(0.4);
    }
  });

  it("is in bins for a variable of few levels", () => {
    const levels = xs.map((_, k) => k % 3);
    const squares = levels.map((x) => x * x);
    expect(lawCurve(levels, squares, "").map(({mean}) => mean)).toEqual([0, 1, 4]);
  });

  it("keeps the ends of a step", () => {
    const law = lawCurve(
      xs,
      xs.map((x) => (x > 0 ? 1 : 0)),
      "deg",
    );
    expect(law[0].mean).toBeCloseTo(0);
    expect(law.at(-1)!.mean).toBeCloseTo(1);
    expect(law.length).toBeGreaterThan(5);
  });

  it("is nothing without readings", () => {
    expect(lawCurve([undefined], [1], "deg")).toEqual([]);
  });
});
