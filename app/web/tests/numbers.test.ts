import {describe, expect, it} from "vitest";
import {clock, duration, probability, roundDown125, roundTicks, short, withSigma} from "../source/drawing/numbers";

describe("figures", () => {
  it("have about three digits and a real minus sign", () => {
    expect(short(0.030214)).toBe("0.0302");
    expect(short(-12.4312)).toBe("−12.4");
    expect(short(4674)).toBe("4,674");
    expect(short(-3.14e-8)).toBe("−3.1e−8");
    expect(short(NaN)).toBe("–");
  });
  it("have as many digits as sigma tells", () => {
    expect(withSigma(0.0585900745, 0.00101218, "deg")).toBe("0.0586 ± 0.0010 deg");
    expect(withSigma(2, null, "in")).toBe("2.00 in");
  });
  it("say certainty only where it is certain", () => {
    expect(probability(0.9997)).toBe("> 99.9 %");
    expect(probability(0.0002)).toBe("< 0.1 %");
    expect(probability(1)).toBe("100.0 %");
  });
  it("of time read as a clock", () => {
    expect(clock(187.46)).toBe("03:07.5");
    expect(duration(229.9)).toBe("3 min 50 s");
  });
  it("make round ticks", () => {
    expect(roundDown125(0.0373)).toBe(0.02);
    expect(roundTicks(0, 1, 5)).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
    expect(roundTicks(-0.021, 0.021, 5)).toEqual([-0.02, -0.01, 0, 0.01, 0.02]);
  });
});
