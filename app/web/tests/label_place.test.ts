// Tests of the place of a label beside a point of a picture.
import {describe, expect, it} from "vitest";
import {labelLeft} from "../source/arm/label_place";

describe("a label", () => {
  it("is at the right of its point, and at the left where it would be cut", () => {
    expect(labelLeft(100, 60, 300)).toBe(110);
    expect(labelLeft(230, 60, 300)).toBe(240);
    expect(labelLeft(231, 60, 300)).toBe(161);
    expect(labelLeft(290, 60, 300)).toBe(220);
  });
  it("begins within a picture that is too narrow for it", () => {
    expect(labelLeft(30, 280, 300)).toBe(0);
  });
});
