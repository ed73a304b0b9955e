import {describe, expect, it} from "vitest";
import {axisEnd, barOf, modelNames, comparedModels, timesFloor} from "../../drawing/ladder.js";
import {acceptanceOf} from "../source/error/ladder";
import {jointsAt, sampleAt} from "../source/plan/sampling";

const model = (fitted: number, heldout: number) => ({name: "", fitted, heldout, worst: 2 * heldout, centred: null});

describe("the ladder", () => {
  it("cuts a first error that would hide all others, and only that", () => {
    expect(axisEnd([model(0.776, 0.776), model(0.0187, 0.0194)], 0.0057)).toBeCloseTo(1.7 * 0.0194);
    expect(axisEnd([model(0.03, 0.03), model(0.0187, 0.0194)], 0.0057)).toBeCloseTo(1.06 * 0.03);
    expect(axisEnd([model(0.03, 0.03)], 0.0057)).toBeCloseTo(1.06 * 0.03);
  });
  it("accepts by the errors that no fit has seen, the largest among them", () => {
    expect(acceptanceOf(model(0.01, 0.02), 0.05)).toBe("accepted");
    expect(acceptanceOf(model(0.01, 0.02), 0.03)).toBe("in part");
    expect(acceptanceOf(model(0.01, 0.02), 0.015)).toBe("rejected");
    expect(acceptanceOf(model(0.01, 0.02), null)).toBe(null);
    expect(acceptanceOf({...model(0.01, 0.02), worst: null}, 0.05)).toBe(null);
  });
  it("names models by the last part of their files, where that tells them apart", () => {
    expect(modelNames(["/tmp/cells/bench.yaml, rigid", "hysteresis@theta4"])).toEqual([
      "bench, rigid",
      "hysteresis@theta4",
    ]);
    expect(modelNames(["a/bench.yaml", "b/bench.yaml"])).toEqual(["a/bench.yaml", "b/bench.yaml"]);
  });
  it("reads errors bare or inside {rms}, and leaves out models without any", () => {
    const entries = [
      {name: "one", rms: 0.02, heldout_rms: {rms: 0.03}},
      {model: "two", rms: null},
    ];
    expect(comparedModels(entries)).toEqual([{name: "one", fitted: 0.02, heldout: 0.03}]);
  });
  it("tells sizes by the floor, and cuts bars at the axis", () => {
    expect(timesFloor(0.0059, 0.0057)).toBe("1.04 × floor");
    expect(timesFloor(0.5, 0.005)).toBe("100 × floor");
    expect(timesFloor(0.5, null)).toBe("");
    expect(barOf(3, 2)).toEqual({share: 1, isCut: true});
    expect(barOf(1, 2)).toEqual({share: 0.5, isCut: false});
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
