// Tests of effects that were added to the model and that the readings do not show.
import {describe, expect, it} from "vitest";
import {withinNoise} from "../source/error/within_noise";

const warning = (at: string, kind: string, atNeutral: boolean) => ({
  ...{sentence: "", effect: "formula", at},
  ...{kind, at_neutral: atNeutral},
});

describe("an effect within the noise", () => {
  const formula = {effect: "formula", at: "theta1"},
    other = {effect: "sag", at: "theta2"};
  it("is not needed, and has no fitted size beyond two sigmas", () => {
    expect(withinNoise([formula, other], [warning("theta1", "not-needed", true)])).toEqual([formula]);
    expect(withinNoise([formula], [warning("theta1", "not-needed", false)])).toEqual([]);
  });
  it("is not one without such a warning, or beside one of a similar place", () => {
    expect(withinNoise([formula], [])).toEqual([]);
    expect(withinNoise([formula], ["formula@theta1 fits"])).toEqual([]);
    expect(withinNoise([formula], [warning("theta1", "beyond-plausible", true)])).toEqual([]);
    expect(withinNoise([formula], [warning("theta1#2", "not-needed", true)])).toEqual([]);
  });
});
