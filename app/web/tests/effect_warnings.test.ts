// Tests of the warnings about effects, and of the sizes of many effects.
import {describe, expect, it} from "vitest";
import {sizeRows} from "../../drawing/explanations.js";
import {warningGroups} from "../source/error/warning_groups";

describe("warnings about effects", () => {
  it("are grouped by kind, in the order of their first occurrence", () => {
    const warning = (kind: string, at: string) => ({kind, effect: "joint-compliance", at, sentence: `${kind} ${at}`});
    const groups = warningGroups([
      warning("not-needed", "link1.z"),
      warning("misfit-remains", "link2.z"),
      warning("not-needed", "link5.z"),
      "a sentence of an earlier version",
    ]);
    expect(groups.map(({kind, warnings}) => [kind, warnings.length])).toEqual([
      ["not-needed", 2],
      ["misfit-remains", 1],
      ["", 1],
    ]);
  });
});

describe("the sizes of an explanation", () => {
  const softness = (k: number) => ({
    effect: "joint-compliance",
    at: `link${k}.z`,
    parameters: {compliance: {value: 2e-4 * k, sigma: 1e-5, unit: "deg/(N*mm)"}},
  });

  it("are a table from four effects on, with the stiffness of compliances", () => {
    const table = sizeRows({effects: [1, 2, 3, 4].map(softness)})!;
    expect(table.heads).toHaveLength(6);
    expect(table.rows).toHaveLength(4);
    expect(table.rows[1].slice(0, 3)).toEqual(["link2.z", "compliance", "4.00e\u22124"]);
    expect(table.rows[1][5]).toMatch(/^2,500 N/);
  });

  it("are no table for few effects", () => {
    expect(sizeRows({effects: [softness(1)]})).toBeNull();
  });
});
