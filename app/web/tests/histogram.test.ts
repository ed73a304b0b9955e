// Tests of histograms: common round bins, and the values that are counted.
import {describe, expect, it} from "vitest";
import {histogramOf, shareCounts} from "../../drawing/histogram.js";

const sum = (counts: readonly number[]) => counts.reduce((all, count) => all + count, 0);

describe("a histogram", () => {
  it("counts every known value of each series once, on common bins", () => {
    const before = [0.9, 1.1, 2.4, null, Number.NaN, 3],
      after = [0.1, 0.2, 0.2];
    const {edges, counts, width} = histogramOf([before, after]);
    expect(counts.map(sum)).toEqual([4, 3]);
    expect(edges[0]).toBeLessThanOrEqual(0.1);
    expect(edges.at(-1)! + width).toBeGreaterThanOrEqual(3);
    const at = edges.findIndex((edge) => edge <= 0.2 && 0.2 < edge + width);
    expect(counts[1][at]).toBe(2);
  });

  it("has bins of a round width, each beginning at a multiple of it", () => {
    const {edges, width} = histogramOf([[0.37, 9.2]]);
    expect(width).toBe(0.5);
    expect(edges[0]).toBe(0);
    expect(edges).toHaveLength(19);
  });

  it("has one bin for equal values, and none without values", () => {
    expect(histogramOf([[2, 2]]).counts).toEqual([[2]]);
    expect(histogramOf([[null], []])).toEqual({width: 0, edges: [], counts: [[], []]});
  });
});

describe("counts of shares", () => {
  it("have the ends and the multiples of the width in one interval each", () => {
    expect(shareCounts([0, 0.3, 0.999, 1], 10)).toEqual([1, 0, 0, 1, 0, 0, 0, 0, 0, 2]);
  });
});
