import {describe, expect, it} from "vitest";
import {acceptanceOf, axisEnd, rungName} from "../source/error/ladder";
import {jointsAt, sampleAt} from "../source/plan/sampling";

const rung = (fitted: number, heldout: number) => ({name: "", fitted, heldout, worst: 2 * heldout, centred: null});

describe("the ladder", () => {
  it("cuts a first error that would hide all others, and only that", () => {
    expect(axisEnd([rung(0.776, 0.776), rung(0.0187, 0.0194)], 0.0057)).toBeCloseTo(1.7 * 0.0194);
    expect(axisEnd([rung(0.03, 0.03), rung(0.0187, 0.0194)], 0.0057)).toBeCloseTo(1.06 * 0.03);
    expect(axisEnd([rung(0.03, 0.03)], 0.0057)).toBeCloseTo(1.06 * 0.03);
  });
  it("accepts by the errors that no fit has seen, the largest among them", () => {
    expect(acceptanceOf(rung(0.01, 0.02), 0.05)).toBe("accepted");
    expect(acceptanceOf(rung(0.01, 0.02), 0.03)).toBe("in part");
    expect(acceptanceOf(rung(0.01, 0.02), 0.015)).toBe("rejected");
    expect(acceptanceOf(rung(0.01, 0.02), null)).toBe(null);
    expect(acceptanceOf({...rung(0.01, 0.02), worst: null}, 0.05)).toBe(null);
  });
  it("names models by the last part of their files", () => {
    expect(rungName("/tmp/cells/bench.yaml, rigid")).toBe("bench, rigid");
    expect(rungName("hysteresis@theta4")).toBe("hysteresis@theta4");
  });
});

describe("playing", () => {
  const path = {
    time: [0, 1, 3],
    segment: [1, 1, 2],
    kind: ["approach", "approach", "travel"],
    joints: [
      [0, 10],
      [2, 20],
      [6, 0],
    ],
    clearance: null,
  };
  it("finds the sample at or before a time", () => {
    expect([-1, 0, 0.99, 1, 2.9, 3, 9].map((at) => sampleAt(path.time, at))).toEqual([0, 0, 0, 1, 1, 2, 2]);
  });
  it("goes straight between samples and stays at the ends", () => {
    expect(jointsAt(path, 2)).toEqual([4, 10]);
    expect(jointsAt(path, 99)).toEqual([6, 0]);
    expect(jointsAt(path, -5)).toEqual([0, 10]);
  });
});
