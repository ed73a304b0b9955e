import {describe, expect, it} from "vitest";
import type {PlanDocument, SheetDocument} from "../source/server/documents";
import {fromPixel, toPixel} from "../../drawing/frames.js";
import {makeSheetModel, sheetWords, spacedTicks} from "../../drawing/sheet_model.js";
import {isInside} from "../source/drawing/lasso";
import {fit, panned, zoomed} from "../source/sheet/sheet_camera";
import {bandEdges, byState, bySteps} from "../source/sheet/colourings";
import {holeName, neighbour} from "../source/sheet/sheet_model";

/** Returns a sheet with one leg of five rows and eleven columns, seen from below: u = -x. */
function grid(): SheetDocument {
  const row: number[] = [],
    column: number[] = [],
    x: number[] = [],
    y: number[] = [];
  for (let r = 1; r <= 5; ++r)
    for (let c = 1; c <= 11; ++c) {
      row.push(r);
      column.push(c);
      x.push(c - 6);
      y.push(1 + r);
    }
  return {
    name: "grid",
    units: "in",
    pitch: 1,
    hole_diameter: 0.7,
    rows: 5,
    columns: 11,
    viewing_side: "below",
    view_words: "seen from below",
    leg: "hot",
    leg_words: "hot leg",
    manway: null,
    holes: {
      row,
      column,
      x,
      y,
      z: x.map(() => 0),
      u: x.map((value) => -value),
      v: y,
      state: x.map((_, i) => (i === 3 ? 1 : 0)),
      states: ["open", "to-plug"],
      state_words: ["open", "recommended to plug"],
    },
  };
}

describe("a sheet", () => {
  const sheet = makeSheetModel(grid());
  it("knows that it is one leg, and where rows and columns are", () => {
    expect(sheet.isOneLeg).toBe(true);
    expect(sheet.rowTicks.map((tick) => tick.place)).toEqual([2, 3, 4, 5, 6]);
    expect(sheet.columnTicks.find((tick) => tick.value === 1)?.place).toBe(5);
  });
  it("marks steps by the base that a plan is of", () => {
    const step_words = ["none", "one", "two", "three"];
    const marks = (base: PlanDocument["base"]) =>
      bySteps(sheet, {tubes: [], unreachable: [], step_words, base} as unknown as PlanDocument, "predicted")
        .kinds.slice(0, 4)
        .map((kind) => kind.mark.shape);
    expect(marks({placed: false, words: "for the nominal base; not calibrated"})).toEqual([
      "plus",
      "hollow-triangle",
      "hollow-square",
      "crossed-ring",
    ]);
    for (const base of [{placed: true}, {}, undefined])
      expect(marks(base)).toEqual(["cross", "triangle", "square", "disc"]);
  });
  it("finds every hole from near its centre, and none from far", () => {
    for (let i = 0; i < sheet.count; ++i) expect(sheet.nearest(sheet.u[i] + 0.3, sheet.v[i] - 0.3, 0.5)).toBe(i);
    expect(sheet.nearest(40, 40, 0.5)).toBe(-1);
    expect(sheet.find(3, 7)).toBe(2 * 11 + 6);
  });
  it("ends at the divider plate, a rim beyond its outermost hole", () => {
    const radius = Math.hypot(5, 6) + 1.4;
    expect(sheet.plate).toEqual({left: -radius, right: radius, bottom: 0, top: radius});
    expect(sheet.isLower).toBe(false);
  });
  it("is named, with its holes and their states, in the words that it came with", () => {
    expect(sheetWords(sheet)).toBe("hot leg, seen from below");
    expect(holeName(sheet, sheet.find(3, 7))).toBe("R3\u00a0C7");
    expect(byState(sheet).kinds.map(({name}) => name)).toEqual(["open", "recommended to plug"]);
    expect(byState(sheet).counts).toEqual([54, 1]);
  });
  it("writes as many numbers as there is room for", () => {
    const ticks = Array.from({length: 40}, (_, k) => ({value: k + 1, place: k}));
    expect(spacedTicks(ticks, 40)).toHaveLength(40);
    expect(spacedTicks(ticks, 4).map(({value}) => value)).toEqual([10, 20, 30, 40]);
  });
  it("goes from hole to hole as the picture shows it", () => {
    const middle = sheet.find(3, 6);
    expect(neighbour(sheet, middle, 1, 0)).toBe(sheet.find(3, 5));
    expect(neighbour(sheet, middle, 0, 1)).toBe(sheet.find(4, 6));
    expect(neighbour(sheet, sheet.find(5, 6), 0, 1)).toBe(sheet.find(5, 6));
  });
});

describe("the camera", () => {
  const size = {width: 800, height: 600};
  const camera = fit({left: -60, right: 60, bottom: 0, top: 60}, size);
  it("brings a place to a pixel and back", () => {
    const [x, y] = toPixel(camera, size, 12.5, 40);
    const [u, v] = fromPixel(camera, size, x, y);
    expect(u).toBeCloseTo(12.5, 9);
    expect(v).toBeCloseTo(40, 9);
  });
  it("zooms about the pointer, within limits", () => {
    const before = fromPixel(camera, size, 200, 150);
    const after = fromPixel(zoomed(camera, size, 200, 150, 3, [1, 100]), size, 200, 150);
    expect(after[0]).toBeCloseTo(before[0], 9);
    expect(after[1]).toBeCloseTo(before[1], 9);
    expect(zoomed(camera, size, 0, 0, 1e9, [1, 100]).scale).toBe(100);
  });
  it("moves with the pointer", () => {
    const before = fromPixel(camera, size, 100, 100);
    const after = fromPixel(panned(camera, 30, -20), size, 130, 80);
    expect(after[0]).toBeCloseTo(before[0], 9);
    expect(after[1]).toBeCloseTo(before[1], 9);
  });
});

describe("a lasso", () => {
  it("holds what lies inside, also where it is hollow", () => {
    const hollow: [number, number][] = [
      [0, 0],
      [10, 0],
      [10, 10],
      [6, 10],
      [6, 4],
      [4, 4],
      [4, 10],
      [0, 10],
    ];
    expect(isInside(hollow, 2, 8)).toBe(true);
    expect(isInside(hollow, 5, 8)).toBe(false);
    expect(isInside(hollow, 5, 2)).toBe(true);
    expect(isInside(hollow, 11, 5)).toBe(false);
  });
});

describe("bands", () => {
  it("are rounded, rising, and none where all is one value", () => {
    const edges = bandEdges(Array.from({length: 1000}, (_, i) => 0.001 + i * 1e-5));
    expect(edges.every((edge, i) => i === 0 || edge > edges[i - 1])).toBe(true);
    expect(edges.length).toBe(5);
    expect(bandEdges([2, 2, 2])).toEqual([]);
  });
});
