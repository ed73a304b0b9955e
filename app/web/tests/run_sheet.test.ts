import {describe, expect, it} from "vitest";
import {fieldsOf, filledRows, isOfRow, openColumns, tableOf, withTyped} from "../source/error/run_sheet_table";

const SHEET = `id,kind,point,load_lbf,theta1_deg,x_in,y_in,z_in,theta1_dir
N1,position,,0,12.5,,,,1
N2,position,"a, b",20,-3,,,,-1
`;

describe("a run sheet", () => {
  it("says what is to be filled in", () => {
    expect(fieldsOf('N2,"a, ""b""", 3 ,')).toEqual(["N2", 'a, "b"', "3", ""]);
    expect(openColumns(tableOf(SHEET))).toEqual(["x_in", "y_in", "z_in"]);
  });
  it("gives back the rows that are filled in whole", () => {
    const open = openColumns(tableOf(SHEET));
    expect(filledRows(SHEET, open)).toBe("");
    const half = SHEET.replace("12.5,,,", "12.5,1,2,3").replace("-3,,,", "-3,4,,");
    expect(tableOf(filledRows(half, open)).rows.map(([id]) => id)).toEqual(["N1"]);
    const typed = {N2: {x_in: "4", y_in: "5", z_in: " 6 "}};
    const text = withTyped({text: SHEET, ticked: [], typed, separations: []});
    expect(filledRows(text, open)).toContain('N2,position,"a, b",20,-3,4,5,6,-1');
  });
  it("of touches has nothing to be filled in: every row that comes back counts", () => {
    const touches = "id,kind,point,theta1_deg\nN1,touch,N1,3\n";
    expect(openColumns(tableOf(touches))).toEqual([]);
    expect(filledRows(touches, [])).toBe(touches);
  });
  it("tells a row that is refused from columns that are", () => {
    const text = "# made by hand\nid,kind\n1,position\n";
    expect(isOfRow("bad.csv:3 (kind)", text)).toBe(true);
    expect(isOfRow("bad.csv:2", text)).toBe(false);
    expect(isOfRow("bad.csv", text)).toBe(false);
    expect(isOfRow(undefined, text)).toBe(false);
  });
});
