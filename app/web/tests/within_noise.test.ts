// Tests of effects that were added to the model and that the readings do not show.
import {describe, expect, it} from "vitest";
import {withinNoise} from "../source/error/within_noise";

const number = (name: string, value: number, sigma: number | null) => ({
  ...{name, value, sigma, start: 0, unit: "deg", identifiable: "yes"},
  interval: null,
});

describe("an effect within the noise", () => {
  const formula = {effect: "formula", at: "theta1"},
    other = {effect: "sag", at: "theta2"};
  it("has no fitted size beyond two sigmas", () => {
    const own = [
      number("formula@theta1.c", 0.001, 0.001),
      number("sag@theta2.a", 0.1, 1),
      number("sag@theta2.b", 3, 1),
    ];
    expect(withinNoise([formula, other], own)).toEqual([formula]);
  });
  it("is not one without fitted sizes, or beside one of a similar place", () => {
    expect(withinNoise([formula], [number("formula@theta1.c", 0, null)])).toEqual([]);
    expect(withinNoise([formula], [number("formula@theta1#2.c", 0, 1)])).toEqual([]);
  });
});
