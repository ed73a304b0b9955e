// Tests of the smooth curve through values along a variable.
import {describe, expect, it} from "vitest";
import {smoothed} from "../../drawing/smoothed.js";

describe("the smooth curve", () => {
  it("is the line itself for values on a line, without spread", () => {
    const curve = smoothed(Array.from({length: 50}, (_, k) => [k / 10, 3 - k / 5]))!;
    for (const {x, mean, spread} of curve) {
      expect(mean).toBeCloseTo(3 - 2 * x, 9);
      expect(spread).toBeCloseTo(0, 6);
    }
  });
  it("passes through the means of repeated values, with their spread", () => {
    const rows = [0, 1, 2, 3].flatMap((x): [number, number][] => [
      [x, 4],
      [x, 6],
    ]);
    const [first] = smoothed(rows)!;
    expect(first.mean).toBeCloseTo(5, 9);
    expect(first.spread).toBeCloseTo(1, 9);
    expect(smoothed(rows.slice(0, 6))).toBeNull();
  });
  it("takes 30,000 readings within a second, all different or all at few places", () => {
    const rows = (places: number) =>
      Array.from({length: 30_000}, (_, k): [number, number] => [k % places, Math.sin(k / 1000)]);
    for (const places of [30_000, 4]) {
      const start = performance.now();
      expect(smoothed(rows(places))).toHaveLength(121);
      expect(performance.now() - start).toBeLessThan(1000);
    }
  });
});
