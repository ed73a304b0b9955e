// Tests of fitted bases in the table of fitted numbers.
import {describe, expect, it} from "vitest";
import {baseRows} from "../source/error/base_rows";
import type {IdentifyDocument} from "../source/server/documents";

describe("a fitted base", () => {
  const base = {position: [1, 2, 3], rpy: [0.1, 0.2, 0.3]};
  const document = {
    units: {length: "in", angle: "deg", force: "lbf"},
    bases: [
      {setup: "", known: true, base},
      {setup: "second", known: false, base},
    ],
    base_steps: [
      {name: "base.shift.y@second", value: 0.5, sigma: 0.01, start: 0, unit: "in", identifiable: "yes", interval: null},
      {name: "base.turn.z@second", value: 0, sigma: null, start: 0, unit: "deg", identifiable: "no", interval: null},
    ],
  } as Partial<IdentifyDocument> as IdentifyDocument;
  it("has rows of its pose, with the sigmas of its steps", () => {
    const rows = baseRows(document);
    expect(rows.map(({name, value, unit}) => [name, value, unit])).toEqual([
      ["base.position.x@second", 1, "in"],
      ["base.position.y@second", 2, "in"],
      ["base.position.z@second", 3, "in"],
      ["base.turn.x@second", 0.1, "deg"],
      ["base.turn.y@second", 0.2, "deg"],
      ["base.turn.z@second", 0.3, "deg"],
    ]);
    expect([rows[1].sigma, rows[0].sigma, rows[5].identifiable]).toEqual([0.01, null, "no"]);
  });
  it("is missing where no base was fitted, or the document is of an earlier version", () => {
    expect(baseRows({...document, bases: document.bases!.slice(0, 1)})).toEqual([]);
    expect(baseRows({units: document.units} as IdentifyDocument)).toEqual([]);
  });
});
