// The choice of units: an address names it, and numbers go from each unit to each other and back.
import {afterEach, describe, expect, it, vi} from "vitest";
import {inUnit, type UnitTable} from "../source/server/unit_table";

const TABLE: UnitTable = {
  length: [
    {name: "in", factor: 0.0254},
    {name: "mm", factor: 0.001},
  ],
  angle: [
    {name: "deg", factor: Math.PI / 180},
    {name: "rad", factor: 1},
  ],
};

afterEach(() => vi.unstubAllGlobals());

async function withKept(kept: unknown) {
  vi.resetModules();
  vi.stubGlobal("localStorage", {getItem: () => JSON.stringify(kept)});
  return import("../source/server/chosen_units");
}

describe("chosen units", () => {
  it("stand in every address, once something was chosen", async () => {
    for (const length of ["", "mm", "ft"])
      for (const angle of ["", "rad"]) {
        const {inChosenUnits} = await withKept({length, angle});
        const query = length + angle === "" ? "" : `units=${length},${angle}`;
        expect(inChosenUnits("/api/state")).toBe(`/api/state${query && `?${query}`}`);
        expect(inChosenUnits("/api/a?b=1")).toBe(`/api/a?b=1${query && `&${query}`}`);
      }
  });

  it("that are none are left out", async () => {
    for (const kept of [null, [], {length: null, angle: 3}])
      expect((await withKept(kept)).inChosenUnits("/api/state")).toBe("/api/state");
  });

  it("go from each to each and back", () => {
    for (const units of [TABLE.length, TABLE.angle])
      for (const {name: from} of units)
        for (const {name: to} of units)
          expect(inUnit(inUnit(1.25, from, to, TABLE), to, from, TABLE)).toBeCloseTo(1.25, 9);
    expect(inUnit(1, "in", "mm", TABLE)).toBe(25.4);
    expect(inUnit(180, "deg", "rad", TABLE)).toBeCloseTo(Math.PI, 9);
    expect(inUnit(5, "lbf", "mm", TABLE)).toBe(5);
  });
});
