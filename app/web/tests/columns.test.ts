import {describe, expect, it} from "vitest";
import {chosenColumns, type ColumnsDocument, guessed, missingOf} from "../source/shell/columns_choice";
import {unitOfOthers, withUnit} from "../source/shell/columns_units";

const document: ColumnsDocument = {
  tables: [
    {name: "log.csv", columns: ["J1", "J2 [deg]", "Note"], rows: [["1", "2", "a"]], count: 1, names: null},
    {name: "points.txt", columns: ["column 1", "column 2"], rows: [["P1", "3"]], count: 1, names: null},
  ],
  targets: [
    {quantity: "point", units: [], is_required: false, found: {table: 1, column: 0, unit: ""}},
    {quantity: "q1", units: ["deg", "rad"], is_required: true, found: {table: 0, column: 0, unit: ""}},
    {quantity: "q2", units: ["deg", "rad"], is_required: true, found: {table: 0, column: 1, unit: "deg"}},
    {quantity: "x", units: ["in", "mm"], is_required: false, found: null},
  ],
  options: [],
};

describe("columns of foreign tables", () => {
  it("begin as the program found them, and a unit that nobody stated is asked for", () => {
    const choices = guessed(document);
    expect(choices[0].map((choice) => choice.quantity)).toEqual(["q1", "q2", ""]);
    expect(missingOf(document, choices)).toEqual(["the unit of q1"]);
  });

  it("are said as the server takes them", () => {
    const choices = guessed(document);
    choices[0][0].unit = "rad";
    choices[1][1] = {quantity: "x", unit: "mm"};
    expect(missingOf(document, choices)).toEqual([]);
    expect(chosenColumns(document, choices)).toEqual([
      "q1_rad=log.csv:J1",
      "q2_deg=log.csv:J2 [deg]",
      "point=points.txt:column 1",
      "x_mm=points.txt:column 2",
    ]);
  });

  it("of one dimension take a unit together, except where the table states one", () => {
    const axes = {units: ["in", "mm"], is_required: false, found: null};
    const more = {...document, targets: [...document.targets, {...axes, quantity: "y"}]};
    const choices = guessed(more);
    choices[0][2] = {quantity: "y", unit: ""};
    choices[1][1] = {quantity: "x", unit: ""};
    const units = (of: typeof choices) => of.flat().map(({unit}) => unit);
    const inches = withUnit(more, choices, [1, 1], "in");
    expect(units(inches)).toEqual(["", "deg", "in", "", "in"]);
    expect(units(withUnit(more, inches, [0, 2], "mm"))).toEqual(["", "deg", "mm", "", "mm"]);
    expect(units(withUnit(more, inches, [0, 0], "rad"))).toEqual(["rad", "deg", "in", "", "in"]);
    expect([unitOfOthers(more, inches, "y"), unitOfOthers(more, choices, "y")]).toEqual(["in", ""]);
    expect(unitOfOthers(more, inches, "point")).toBe("");
  });

  it("are said with the factor of pulses, with its sign", () => {
    const choices = guessed(document);
    choices[0][0] = {quantity: "q1", unit: "deg", factor: "-0.00012"};
    choices[0][1].factor = "";
    expect(chosenColumns(document, choices).slice(0, 2)).toEqual([
      "q1_deg=log.csv:J1*-0.00012",
      "q2_deg=log.csv:J2 [deg]",
    ]);
  });

  it("are each one thing, and every joint has one", () => {
    const choices = guessed(document);
    choices[0][0] = {quantity: "q2", unit: "deg"};
    expect(missingOf(document, choices)).toEqual(["a column for q1", "only one column for q2"]);
  });
});

describe("columns of a work list", () => {
  const list: ColumnsDocument = {
    tables: [
      {name: "list.csv", columns: ["Reihe", "Spalte", "Dauer"], rows: [["1", "2", "30"]], count: 1, names: null},
    ],
    targets: ["row", "column", "tube", "dwell"].map((quantity) => ({
      quantity,
      units: quantity === "dwell" ? ["s"] : [],
      is_required: false,
      found: null,
    })),
    options: [],
    needs: [["tube"], ["row", "column"]],
  };
  const chosen = (...quantities: string[]) => [
    quantities.map((quantity) => ({quantity, unit: quantity === "dwell" ? "s" : ""})),
  ];

  it("are enough where one list of what is needed is whole", () => {
    const lacks = "a column for tube, or for row and column";
    expect(missingOf(list, guessed(list))).toEqual([lacks]);
    expect(missingOf(list, chosen("row", "", ""))).toEqual([lacks]);
    expect(missingOf(list, chosen("row", "column", "dwell"))).toEqual([]);
    expect(missingOf(list, chosen("", "tube", ""))).toEqual([]);
  });

  it("are said as the server takes them", () => {
    expect(chosenColumns(list, chosen("row", "column", "dwell"))).toEqual([
      "row=list.csv:Reihe",
      "column=list.csv:Spalte",
      "dwell_s=list.csv:Dauer",
    ]);
  });
});
