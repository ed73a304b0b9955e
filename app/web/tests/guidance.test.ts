// Tests of the steps after a verdict: which apply, their order and their evidence.
import {describe, expect, it} from "vitest";
import {adviceAfter, type Known} from "../source/error/guidance";
import type {DiagnoseDocument} from "../source/server/documents";

function known(document: Partial<DiagnoseDocument>, more: Partial<Known> = {}): Known {
  const diagnosis = {
    verdict: "unexplained",
    units: {length: "mm", angle: "deg", force: "N"},
    rms: {noise_floor: 0.03, heldout_before: 0.6, heldout_after: 0.5},
    probability: {nothing_missing: 0, unknown_alone: 0.5},
    explanations: [],
    ranking: [],
    next_readings: [],
    warnings: [],
    not_tried: [],
    joints: [],
    ...document,
  } as unknown as DiagnoseDocument;
  return {
    diagnosis,
    comparison: null,
    variables: [],
    missingColumns: [],
    formula: "",
    free: ["geometry"],
    model: null,
    ...more,
  };
}

const namesOf = (given: Known) => adviceAfter(given).map(({name}) => name);
const hysteresis = {effect: "hysteresis", at: "J1"};
const explanation = {
  effects: [hysteresis],
  enough: true,
  chi2: 1,
  p_value: 0,
  rms: 0.5,
  heldout_rms: 0.55,
  probability: 0.9,
};

describe("the steps after a verdict", () => {
  it("begin with what is certain where part is explained, and go on to the remainder", () => {
    const given = known({
      verdict: "partly-explained",
      explanations: [explanation],
      remainder: {size: 0.149, follows: [{variable: "y", share: 0.09}]},
    });
    const [add, remainder] = adviceAfter(given);
    expect(add.act).toEqual({kind: "add", effects: [hysteresis]});
    expect(add.evidence).toContain("0.600 mm to 0.550 mm");
    expect(remainder.evidence).toMatch(/^0\.149 mm follows y \(9\s%\)$/);
    expect(remainder.act).toBeUndefined();
  });

  it("propose no effect where none is certain, and the suggested formula last", () => {
    const ranking = [{...hysteresis, probability: 0.57}] as DiagnoseDocument["ranking"];
    const names = namesOf(known({ranking}, {formula: "J1 += c*sin(J2)", free: []}));
    expect(names).toEqual(["addNothing", "geometry", "formula"]);
  });

  it("begin with the closest explanation where it more than halves the error", () => {
    const ranking = [{...hysteresis, probability: 0.57}] as DiagnoseDocument["ranking"],
      closest = [{...explanation, enough: false, heldout_rms: 0.2}];
    const [step, ...others] = adviceAfter(known({ranking, closest}));
    expect(step).toMatchObject({name: "tryClosest", button: "Add anyway", act: {kind: "add", effects: [hysteresis]}});
    expect(step.evidence).toMatch(/leaves 0\.200 mm of the held-out error of 0\.600 mm; noise alone leaves 0\.0300 mm/);
    expect(others.map(({name}) => name)).not.toContain("addNothing");
    expect(namesOf(known({ranking, closest: [explanation]}))).toContain("addNothing");
  });

  it("ask for readings where explanations are open, with the least chance of a decision", () => {
    const given = known({
      verdict: "ambiguous",
      explanations: [explanation],
      next_readings: [{posture: {J1: 3}}, {posture: {J1: 5}}],
      splitting: {pairs: [{probability_distinguished: 0.9}, {probability_distinguished: 0.8}] as never},
    });
    expect(namesOf(given)).toEqual(["read", "addAnyway"]);
    expect(adviceAfter(given)[0].evidence).toMatch(/^2 readings proposed.* 80\.0\s% or more$/);
  });

  it("offer to remove the effects that are not needed together", () => {
    const warnings = [1, 5].map((k) => ({
      kind: "not-needed",
      effect: "joint-compliance",
      at: `link${k}.z`,
      sentence: "",
    }));
    const [step] = adviceAfter(known({verdict: "partly-explained", warnings}));
    expect(step.name).toBe("needless");
    expect(step.act).toMatchObject({kind: "remove", effects: [{at: "link1.z"}, {at: "link5.z"}]});
  });

  it("are none after a verdict that needs none", () => {
    expect(namesOf(known({verdict: "explained", explanations: [explanation]}))).toEqual([]);
  });
});
