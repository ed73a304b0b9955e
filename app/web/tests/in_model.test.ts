// Tests of what a model has already, for the buttons that add effects or remove them.
import {describe, expect, it} from "vitest";
import {hasCause, standingOf} from "../source/error/in_model";

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
