import {describe, expect, it} from "vitest";
import {axisEnd, barOf, heldOutOf, modelNames, comparedModels, timesFloor} from "../../drawing/ladder.js";
import {budgetText, errorUnit, setAsideText} from "../../drawing/error_budget.js";
import type {DiagnoseDocument, LadderDocument} from "../source/server/documents";
import {acceptanceOf, ladderOf, ladderOfDiagnosis, lastChange} from "../source/error/ladder";
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
  it("compares two held-out errors, or two fitted ones", () => {
    expect(lastChange([model(5, 7.57), model(1.5, 1.77)])).toEqual({before: 7.57, now: 1.77, error: "held-out"});
    const bare = (fitted: number) => ({...model(fitted, fitted), heldout: heldOutOf(fitted, fitted)});
    expect(lastChange([model(5, 7.57), bare(1.77)])).toEqual({before: 5, now: 1.77, error: "fitted"});
    expect(lastChange([bare(7.57), model(1.5, 1.77)])).toEqual({before: 7.57, now: 1.5, error: "fitted"});
    expect(lastChange([model(5, 7.57)])).toBeNull();
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

describe("the one error of a screen", () => {
  const rms = (heldout: number) => ({as_it_stands: 1, fitted: heldout / 2, heldout, noise_floor: 0.03});
  const climbed = {
    model: 4,
    set_aside: ["7", "12"],
    error_unit: "in",
    models: ["rigid", "as given"].map((name, k) => ({
      name,
      chi2_per_dof: 1,
      fitted_numbers: 2,
      rms: rms(0.9 - 0.3 * k),
      worst: rms(2),
    })),
  } as Partial<LadderDocument> as LadderDocument;
  const diagnosed = {
    model: 4,
    set_aside: ["12", "7"],
    error_unit: "in",
    rms: {before: 0.31, heldout_before: 0.61, heldout_after: 0.55, noise_floor: 0.034},
    ladder: [
      {name: "as it stands", rms: 0.7, heldout_rms: null},
      {name: "refitted", rms: 0.31, heldout_rms: 0.61},
      {name: "with hysteresis", rms: 0.3, heldout_rms: 0.55},
    ],
  } as Partial<DiagnoseDocument> as DiagnoseDocument;

  it("is that of the verdict, in its bars too, where both are of the same readings", () => {
    const shown = ladderOfDiagnosis(climbed, diagnosed);
    expect(shown.models.map(({name, heldout}) => [name, heldout])).toEqual([
      ["rigid", 0.9],
      ["as given", 0.61],
    ]);
    expect([shown.floor, shown.models.at(-1)!.fitted]).toEqual([0.034, 0.31]);
  });
  it("is the diagnosis's alone where other readings are set aside, or another model was diagnosed", () => {
    for (const other of [{...climbed, set_aside: []}, {...climbed, model: 3}, null])
      expect(ladderOfDiagnosis(other, diagnosed).models.map(({heldout}) => heldout)).toEqual([null, 0.61]);
  });
  it("is in the unit of what was measured, with the readings that are not in it", () => {
    expect(ladderOf({...climbed, error_unit: "degree"}).unit).toBe("deg");
    expect(errorUnit({units: {length: "mm"}})).toBe("mm");
    expect(setAsideText(diagnosed, 468)).toBe("2 of 468 readings set aside as outliers");
    expect([setAsideText({}, 468), budgetText({}), budgetText({error_budget: {words: "so"}})]).toEqual(["", "", "so"]);
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
