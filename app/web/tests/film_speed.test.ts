// Tests of the speed of a film: a whole path takes a minute at most.
import {describe, expect, it} from "vitest";
import {filmSpeed} from "../source/plan/film_speed";

const OFFERED = [1, 4, 16, 64];

describe("the speed of a film", () => {
  it("stays where the whole path takes a minute at most", () => {
    expect(filmSpeed(60, 1, OFFERED)).toBe(1);
    expect(filmSpeed(600, 16, OFFERED)).toBe(16);
  });
  it("is the least that is enough for a longer path", () => {
    expect(filmSpeed(61, 1, OFFERED)).toBe(4);
    expect(filmSpeed(1800, 4, OFFERED)).toBe(64);
    expect(filmSpeed(6000, 4, OFFERED)).toBe(100);
  });
});
