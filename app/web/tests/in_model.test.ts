// Tests of what a model has already, for the buttons that add effects or remove them.
import {describe, expect, it} from "vitest";
import {effectTitle, explanationTitle} from "../../drawing/explanations.js";
import {hasCause, ofModel, standingOf, withFormulas} from "../source/error/in_model";

const sag = {effect: "sag", at: "theta2"},
  slack = {effect: "slack", at: "theta4"},
  geometry = {effect: "free", at: "geometry"};
const model = (effects: (typeof sag)[], free: string[] = []) => ({effects, free});

describe("an effect of a model", () => {
  it("is one at the same place, or a number that the model fits", () => {
    expect(hasCause(model([sag]), sag)).toBe(true);
    expect(hasCause(model([sag]), {...sag, at: "theta3"})).toBe(false);
    expect(hasCause(model([sag], ["geometry"]), geometry)).toBe(true);
    expect(hasCause(model([geometry]), geometry)).toBe(false);
    expect(hasCause(null, sag)).toBe(false);
  });
});

describe("two formulas on one joint", () => {
  const formula = (at: string, text: string) => ({effect: "formula", at, formula: text});
  const one = formula("theta2", "theta2 += c*sin(theta1)"),
    long = formula("theta2#2", "theta2 += amplitude*cos(theta1 + phase)*load");
  it("are told apart by their shortened texts", () => {
    expect(effectTitle(one)).toBe("formula theta2 += c*sin(theta1)");
    expect(effectTitle(long)).toBe("formula theta2 += amplitude*cos(theta1…");
    expect(explanationTitle({effects: [one, long]})).toBe(`${effectTitle(one)}; ${effectTitle(long)}`);
    expect(ofModel(model([one, long]), {effect: "formula", at: "theta2#2"})).toBe(long);
  });
  it("name their fitted numbers, with the whole text as a hint", () => {
    const number = (name: string) => ({
      ...{name, value: 1, sigma: 1, start: 0, unit: "deg", identifiable: "yes"},
      interval: null,
    });
    const shown = withFormulas(
      ["formula@theta2.c", "formula@theta2#2.phase", "sag@a.b"].map(number),
      model([one, long]),
    );
    expect(shown.map(({title}) => title)).toEqual([
      "c of formula theta2 += c*sin(theta1)",
      `phase of ${effectTitle(long)}`,
      undefined,
    ]);
    expect(shown[1].hint).toBe(`formula@theta2#2.phase: ${long.formula}`);
  });
});

describe("an alternative", () => {
  const one = {effects: [sag, slack]},
    part = {effects: [sag]},
    freed = {effects: [geometry]};
  const all = [one, part, freed];
  it("is added if all its effects are in the model and no larger one holds them", () => {
    const standings = all.map((each) => standingOf(each, all, model([sag, slack])));
    expect(standings).toEqual(["added", "part of the added", "open"]);
    expect(all.map((each) => standingOf(each, all, model([sag])))).toEqual(["open", "added", "open"]);
    expect(standingOf(freed, all, model([], ["geometry"]))).toBe("added");
  });
});
