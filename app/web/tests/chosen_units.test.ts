// The choice of units: an address names it, and numbers go from each unit to each other and back.
import {afterEach, describe, expect, it, vi} from "vitest";
import {inUnit, UNIT_CHOICES} from "../source/server/chosen_units";

afterEach(() => vi.unstubAllGlobals());

async function withKept(kept: unknown) {
  vi.resetModules();
  vi.stubGlobal("localStorage", {getItem: () => JSON.stringify(kept)});
  return import("../source/server/chosen_units");
}

describe("chosen units", () => {
  it("stand in every address, once something was chosen", async () => {
    for (const length of ["", ...UNIT_CHOICES.length])
      for (const angle of ["", ...UNIT_CHOICES.angle]) {
        const {inChosenUnits} = await withKept({length, angle});
        const query = length + angle === "" ? "" : `units=${length},${angle}`;
        expect(inChosenUnits("/api/state")).toBe(`/api/state${query && `?${query}`}`);
        expect(inChosenUnits("/api/a?b=1")).toBe(`/api/a?b=1${query && `&${query}`}`);
      }
  });

  it("that are none are left out", async () => {
    for (const kept of [null, [], {length: "parsec", angle: 3}])
      expect((await withKept(kept)).inChosenUnits("/api/state")).toBe("/api/state");
  });

  it("go from each to each and back", () => {
    for (const units of [
      ["mm", "in", "m", "cm", "ft"],
      ["deg", "rad"],
    ])
      for (const from of units)
        for (const to of units) expect(inUnit(inUnit(1.25, from, to), to, from)).toBeCloseTo(1.25, 9);
    expect(inUnit(1, "in", "mm")).toBe(25.4);
    expect(inUnit(180, "deg", "rad")).toBeCloseTo(Math.PI, 9);
    expect(inUnit(5, "lbf", "mm")).toBe(5);
  });
});
