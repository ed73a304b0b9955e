import {describe, expect, it} from "vitest";
import {addWords, briefTitle, explanationTitle, sizesOf, sizeText} from "../../drawing/explanations.js";
import {
  chance,
  clock,
  duration,
  errorText,
  fixed,
  inverseUnit,
  jointDecimals,
  lengthAndUnit,
  plainUnit,
  probability,
  short,
  tickTexts,
} from "../../drawing/numbers.js";
import {rootTicks, roundDown125, roundTicks, roundUp125, symmetric} from "../../drawing/scales.js";
import {valueAndSigma, withSigma} from "../../drawing/sigma_text.js";

describe("figures", () => {
  it("have about three digits and a real minus sign", () => {
    expect(short(0.030214)).toBe("0.0302");
    expect(short(-12.4312)).toBe("−12.4");
    expect(short(4674)).toBe("4,674");
    expect(short(-3.14e-8)).toBe("−3.1e−8");
    expect(short(28658879022000000)).toBe("2.87e16");
    expect(short(NaN)).toBe("–");
  });
  it("have as many digits as sigma tells", () => {
    expect(withSigma(0.0585900745, 0.00101218, "deg")).toBe("0.0586 ± 0.0010\u00a0deg");
    expect(withSigma(2, null, "in")).toBe("2.00\u00a0in");
    expect(withSigma(9927495, 67123, "lbf/in^2")).toBe("(9.927 ± 0.067)e6\u00a0lbf/in²");
    expect(withSigma(2.8658879e16, 1.8571527e16, "lbf")).toBe("(2.9 ± 1.9)e16\u00a0lbf");
    expect(withSigma(-0.000182, 0.000075)).toBe("(−1.82 ± 0.75)e−4");
    expect(withSigma(3812, 640)).toBe("3,810 ± 640");
    expect(valueAndSigma(12.34567, 0.0123)).toEqual(["12.346", "0.012"]);
    expect(valueAndSigma(319800, 151571)).toEqual(["3.2e5", "1.5e5"]);
  });
  it("have units as drawings write them, and a stiffness beside a compliance", () => {
    expect(plainUnit("deg/(lbf*in)")).toBe("deg/(lbf·in)");
    expect(plainUnit("1/(lbf*in^2)")).toBe("1/(lbf·in²)");
    expect(plainUnit("lbf*in/deg")).toBe("lbf·in/deg");
    expect(inverseUnit("deg/(lbf*in)")).toBe("lbf·in/deg");
    expect(inverseUnit("1/(lbf*in^2)")).toBe("lbf·in²");
    const compliance = {value: 0.0005, sigma: 0.00001, unit: "deg/(lbf*in)"};
    const size = (numbers: object) => sizeText({effect: "joint-compliance", at: "tool.z", parameters: numbers});
    expect(size({compliance})).toBe("compliance (5.00 ± 0.10)e−4\u00a0deg/(lbf·in), stiffness 2,000 lbf·in/deg");
    expect(size({compliance: {...compliance, sigma: 0.0004}})).not.toContain("stiffness");
  });
  it("of small errors have a smaller unit and no power of ten", () => {
    expect([0.5, 0.02, 0.00017, -0.00017, 0].map((value) => errorText(value, "m"))).toEqual([
      "0.500 m",
      "20.0 mm",
      "0.170 mm",
      "−0.170 mm",
      "0 m",
    ]);
    expect([0.0302, 0.00031, 1e-7].map((value) => errorText(value, "in"))).toEqual([
      "0.0302 in",
      "0.00031 in",
      "1.0e−7 in",
    ]);
    expect(errorText(null, "m")).toBe("–");
  });
  it("of several effects stand with their places, effects of one kind together", () => {
    const effects = ["link1.z", "link2.z", "link3.z"].map((at) => ({
      effect: "joint-compliance",
      at,
      parameters: {compliance: {value: 3e-6, sigma: 2e-7, unit: "deg/(N*mm)"}},
    }));
    const more = [...effects, {effect: "hysteresis", at: "A1"}];
    expect(explanationTitle({effects: more})).toBe(
      "joint-compliance at link1.z, link2.z, link3.z and hysteresis at A1",
    );
    expect(briefTitle({effects: more})).toBe("joint-compliance at 3 places and hysteresis at A1");
    const freed = {effect: "free", at: "geometry", title: "geometry: numbers of the arm's file are off"};
    for (const title of [explanationTitle, briefTitle])
      expect(title({effects: [freed, {effect: "hysteresis", at: "A1"}]})).toBe(`hysteresis at A1; ${freed.title}`);
    expect(briefTitle({effects: [freed]})).toBe(freed.title);
    expect(addWords({effects: [freed]})).toBe("Fit the geometry again");
    expect(addWords({effects: [freed, {effect: "hysteresis", at: "A1"}]})).toBe(
      "Add hysteresis at A1 and fit the geometry again",
    );
    expect(sizesOf({effects: more})[1]).toBe(
      "link2.z: compliance (3.00 ± 0.20)e−6\u00a0deg/(N·mm), stiffness 3.33e5 N·mm/deg",
    );
  });
  it("of a sine and a cosine are an amplitude and a phase", () => {
    const number = (value: number) => ({value, sigma: 0.001, unit: "deg"});
    expect(
      sizeText({effect: "transmission-error", at: "q", parameters: {sine: number(0.03), cosine: number(0.04)}}),
    ).toBe("amplitude 0.0500 ± 0.0010\u00a0deg, phase 53.1 ± 1.1\u00a0deg");
    expect(sizeText({effect: "transmission-error", at: "q", parameters: {sine: number(0.03)}})).toMatch(/^sine 0\.03/);
  });
  it("are as fine in any unit of length, and zero has no sign", () => {
    expect(lengthAndUnit(-0.0361234, "m")).toBe("−0.03612 m");
    expect(lengthAndUnit(917.456, "mm")).toBe("917.46 mm");
    expect(lengthAndUnit(36.12345, "in")).toBe("36.123 in");
    expect(fixed(-0.00001, 3)).toBe("0.000");
    expect(fixed(-0.01, 2)).toBe("−0.01");
    expect([jointDecimals("deg"), jointDecimals("rad"), jointDecimals("m")]).toEqual([2, 4, 5]);
  });
  it("of one axis have the same decimals", () => {
    expect(tickTexts([-0.1, -0.05, 0, 0.05, 0.1])).toEqual(["−0.10", "−0.05", "0", "0.05", "0.10"]);
    expect(tickTexts([0, 200, 400])).toEqual(["0", "200", "400"]);
    expect(tickTexts([0, 1e-5, 2e-5])).toEqual(["0", "1.0e−5", "2.0e−5"]);
  });
  it("say certainty only where it is certain", () => {
    expect(probability(0.9997)).toBe(">\u00a099.9\u00a0%");
    expect(probability(0.0002)).toBe("<\u00a00.1\u00a0%");
    expect(probability(1)).toBe("100.0\u00a0%");
  });
  it("of chance are told with one digit where they are small", () => {
    expect(chance(6.4e-173)).toBe("p = 6e−173");
    expect(chance(0)).toBe("p <\u00a01e−300");
    expect(chance(0.0321)).toBe("p = 0.032");
    expect(chance(null)).toBe("not tested");
  });
  it("of time read as a clock", () => {
    expect(clock(187.46)).toBe("03:07.5");
    expect(duration(229.9)).toBe("3 min 50 s");
  });
  it("make round ticks", () => {
    expect(roundDown125(0.0373)).toBe(0.02);
    expect(roundTicks(0, 1, 5)).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
    expect(roundTicks(-0.021, 0.021, 5)).toEqual([-0.02, -0.01, 0, 0.01, 0.02]);
    expect(roundTicks(0, 550, 13)).toEqual([0, 50, 100, 150, 200, 250, 300, 350, 400, 450, 500, 550]);
    expect([0.15, 0.2, 3, 7, 11].map(roundUp125)).toEqual([0.2, 0.2, 5, 10, 20]);
    expect(rootTicks(6)).toEqual([0, 0.1, 0.5, 1, 2, 5]);
    expect(symmetric(-2, 1)).toEqual([-2.16, 2.16]);
  });
});
