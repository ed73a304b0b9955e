// Tests with tools of one to eight steps: counts, names and marks on page and report agree with the document.
import {describe, expect, it} from "vitest";
import {stepCountOf, stepKinds, stepsAtError, stepText} from "../../drawing/steps.js";
import {chancesOf, countsOf, predictedMode, scoredModes, wholeToolText} from "../source/report/plan/cases";
import type {PlanDocument, PlannedTube} from "../source/server/documents";
import {bySteps} from "../source/sheet/colourings";
import type {SheetModel} from "../source/sheet/sheet_model";

const TOOLS = [1, 2, 3, 4, 5, 6, 7, 8];

/**
 * Returns a plan for a tool of n steps: for every k from 0 to n there are k + 1 tubes that k steps enter with the true
 * arm. The most probable number of steps is k + 1, at most n.
 */
function planOf(n: number): PlanDocument {
  const inserted = Array.from({length: n + 1}, (_, k) => Array<number>(k + 1).fill(k)).flat();
  const tubes = inserted.map((steps, i) => {
    const likeliest = Math.min(n, steps + 1);
    const score = {error: 0, dx: 0, dy: 0, steps};
    return {
      row: 1,
      column: i + 1,
      steps: likeliest,
      probability_by_steps: Array.from({length: n + 1}, (_, k) => (k === likeliest ? 0.6 : 0.4 / n)),
      scored: {via_point: score, none: {...score, steps: 0}},
    };
  }) as Partial<PlannedTube>[] as PlannedTube[];
  const counts = {
    via_point: Array.from({length: n + 1}, (_, k) => k + 1),
    none: [tubes.length, ...Array<number>(n).fill(0)],
  };
  const step_words = Array.from({length: n + 1}, (_, k) => `${k} of ${n}`);
  return {
    tubes,
    unreachable: [{row: 2, column: 1, reason: "far"}],
    counts,
    step_words,
  } as Partial<PlanDocument> as PlanDocument;
}

/** Returns the plan in the form of a report's document, with the compensation modes side by side. */
const reported = (plan: PlanDocument) => ({
  ...plan,
  tubes: plan.tubes.map((tube) => ({...tube, ...tube.scored})),
  modes: [{name: "none"}, {name: "via_point"}],
  steps: plan.counts!.none.slice(1).map((_, k) => ({diameter: 0.1 * (k + 1), tolerance: 1 / (k + 1)})),
});

/**
 * Returns a sheet whose row 1 has a hole for each tube; row 2 has a hole out of reach and a hole that was not
 * requested.
 */
const sheetFor = (plan: PlanDocument) =>
  ({
    count: plan.tubes.length + 2,
    find: (row: number, column: number) => (row === 1 ? column - 1 : plan.tubes.length),
  }) as Partial<SheetModel> as SheetModel;

describe.each(TOOLS)("a tool of %i steps", (n) => {
  const plan = planOf(n);
  it("has a name and a mark of its own for each number of inserted steps", () => {
    const kinds = stepKinds(plan);
    expect(kinds.map(({name}) => name)).toEqual(plan.step_words);
    expect(new Set(kinds.map(({mark}) => mark.shape)).size).toBe(n + 1);
    expect([kinds[0].mark.shape, kinds[n].mark.shape]).toEqual(["cross", "disc"]);
  });
  it("has other marks, of colours of their own, for a base that nobody placed", () => {
    const placed = stepKinds(plan).map(({mark}) => mark);
    const nominal = stepKinds({...plan, base: {placed: false}} as PlanDocument).map(({mark}) => mark);
    expect(new Set([...placed, ...nominal].map(({shape}) => shape)).size).toBe(2 * (n + 1));
    for (const {colour} of nominal) expect(placed.map((mark) => mark.colour)).not.toContain(colour);
    for (const base of [{placed: true}, {}, null, undefined])
      expect(stepKinds({...plan, base} as PlanDocument).map(({mark}) => mark)).toEqual(placed);
  });
  it("is known by words, steps, counts or probabilities alike", () => {
    const {step_words, counts, tubes} = plan;
    for (const known of [{step_words}, {steps: reported(plan).steps}, {counts}, {tubes}])
      expect(stepCountOf(known)).toBe(n);
  });
  it("is counted on the page's sheet as the plan counts it", () => {
    const shown = bySteps(sheetFor(plan), plan, "via_point");
    expect(shown.counts).toEqual([...plan.counts!.via_point, 1, 1]);
    expect(bySteps(sheetFor(plan), plan, "none").counts).toEqual([...plan.counts!.none, 1, 1]);
    const expected = stepKinds(plan).map((_, k) => plan.tubes.filter(({steps}) => steps === k).length);
    expect(bySteps(sheetFor(plan), plan, "predicted").counts.slice(0, n + 1)).toEqual(expected);
  });
  it("is not known on page and report alike for a base that allows no probabilities", () => {
    const tubes = plan.tubes.map((tube) => ({...tube, probability_by_steps: null})),
      unknown = {...plan, tubes};
    const {kinds, counts} = bySteps(sheetFor(plan), unknown, "predicted");
    expect([kinds.at(-1)!.name, counts.at(-1)]).toEqual(["steps not known", tubes.length]);
    expect(counts.slice(0, n + 1)).toEqual(kinds.slice(0, n + 1).map(() => 0));
    expect(tubes.map((tube) => predictedMode(reported(unknown)).caseOf(tube))).toEqual(tubes.map(() => null));
  });
  it("is counted in the report as the plan counts it", () => {
    const document = reported(plan);
    for (const mode of ["via_point", "none"]) {
      expect(countsOf(document, mode)).toEqual(plan.counts![mode]);
      expect(countsOf({...document, counts: null}, mode)).toEqual(plan.counts![mode]);
    }
    const modes = scoredModes(document);
    expect(modes.map(({key}) => key)).toEqual(["none", "via_point"]);
    document.tubes.forEach((tube, i) => {
      for (const {key, caseOf} of modes)
        expect(caseOf(tube)).toBe(plan.tubes[i].scored![key as "none" | "via_point"]!.steps);
      expect(predictedMode(document).caseOf(tube)).toBe(plan.tubes[i].steps);
      expect(chancesOf(tube, document)).toEqual(plan.tubes[i].probability_by_steps);
    });
    expect(wholeToolText(document)).toContain(`${n} of ${n} in ${n + 1} of ${plan.tubes.length} tubes`);
  });
  it("goes in as far as its tolerances let it", () => {
    const tolerances = reported(plan).steps.map(({tolerance}) => tolerance);
    tolerances.forEach((tolerance, k) => {
      expect(stepsAtError(tolerance, tolerances)).toBe(k + 1);
      expect(stepsAtError(tolerance * 1.001, tolerances)).toBe(k);
    });
  });
});

describe("a document without words", () => {
  it("counts its steps", () => {
    expect([stepText(["none"], 0), stepText(["none"], 2), stepText(undefined, 1)]).toEqual([
      "none",
      "2 steps",
      "1 step",
    ]);
    expect(stepCountOf({})).toBe(0);
    expect(stepKinds({}).length).toBe(1);
  });
});
