// Tests of the closest explanations: their order, the one worth a trial, and effects that do not differ from zero.
import {describe, expect, it} from "vitest";
import {byHeldOut, closestToTry, isSizeWithinNoise, isWithinNoise} from "../../drawing/closest.js";

const effect = (at: string, value = 1, sigma: number | null = 0.1) => ({
  effect: "sag",
  at,
  parameters: {size: {value, sigma, unit: "mm"}},
});
const closest = (heldout_rms: number | null, ...effects: ReturnType<typeof effect>[]) => ({effects, heldout_rms});
const document = (...all: ReturnType<typeof closest>[]) => ({
  verdict: "unexplained",
  closest: all,
  rms: {heldout_before: 1},
});

describe("the closest explanations", () => {
  const two = closest(0.2, effect("a"), effect("b")),
    one = closest(0.203, effect("a")),
    other = closest(0.4, effect("c")),
    unknown = closest(null, effect("d"));
  it("are ordered by held-out error, and by the number of effects within 2 % of the smallest", () => {
    expect(byHeldOut([unknown, other, two, one])).toEqual([one, two, other, unknown]);
    expect(byHeldOut([unknown])).toEqual([unknown]);
  });
  it("are worth a trial where they more than halve the error and differ from zero", () => {
    expect(closestToTry(document(other, two, one))).toBe(one);
    expect(closestToTry(document(closest(0.1, effect("a"), effect("b", 0.1)), other))).toBe(other);
    expect(closestToTry(document(closest(0.6, effect("a")), unknown))).toBeNull();
    expect(closestToTry({...document(one), verdict: "explained"})).toBeNull();
  });
});

describe("an effect within two standard deviations of zero", () => {
  it("has only such sizes; numbers of the arm's file are no deviations from zero", () => {
    expect(isWithinNoise(effect("a", -0.19))).toBe(true);
    expect(isWithinNoise(effect("a", 0.21))).toBe(false);
    expect(isWithinNoise(effect("a", 0, null))).toBe(false);
    expect(isWithinNoise({...effect("a", 0.1), effect: "free"})).toBe(false);
    expect(isSizeWithinNoise({effect: "sag", size: {value: 1, sigma: 0.6}})).toBe(true);
    expect(isSizeWithinNoise({effect: "sag", size: null})).toBe(false);
  });
});
