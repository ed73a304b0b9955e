import {describe, expect, it} from "vitest";
import {
  fieldsOf,
  fillById,
  filledRows,
  isOfRow,
  openColumns,
  tableOf,
  withTyped,
  type RunSheet,
} from "../source/error/run_sheet_table";

const TEXT = `id,kind,point,load_lbf,theta1_deg,x_in,y_in,z_in,theta1_dir
N1,position,,0,12.5,,,,1
N2,position,"a, b",20,-3,,,,-1
`;
const PLACE = {columns: ["x_in", "y_in", "z_in"], least: 3, optional: []};
const SHEET: RunSheet = {text: TEXT, fill: [PLACE, PLACE], ticked: [], typed: {}, separations: []};

describe("a run sheet", () => {
  it("asks for what the program says is to be filled in, whatever else is empty", () => {
    expect(fieldsOf('N2,"a, ""b""", 3 ,')).toEqual(["N2", 'a, "b"', "3", ""]);
    expect(openColumns(SHEET)).toEqual(["x_in", "y_in", "z_in"]);
    const touch = {columns: ["theta1_deg"], least: 1, optional: ["time_min"]};
    const text = "id,kind,point,theta1_deg,near_theta1_deg,x_in,time_min\nN1,touch,N1,,3,,\n";
    expect(openColumns({...SHEET, text, fill: [touch]})).toEqual(["theta1_deg", "time_min"]);
  });
  it("gives back the rows that are filled in whole, or those that are begun", () => {
    const fill = fillById(SHEET);
    expect(filledRows(TEXT, fill, "begun")).toBe("");
    const half = TEXT.replace("12.5,,,", "12.5,1,2,3").replace("-3,,,", "-3,4,,");
    const ids = (text: string) => tableOf(text).rows.map(([id]) => id);
    expect(ids(filledRows(half, fill, "whole"))).toEqual(["N1"]);
    expect(ids(filledRows(half, fill, "begun"))).toEqual(["N1", "N2"]);
    const typed = {N2: {x_in: "4", y_in: "5", z_in: " 6 "}};
    const text = withTyped({...SHEET, typed});
    expect(filledRows(text, fill, "whole")).toContain('N2,position,"a, b",20,-3,4,5,6,-1');
  });
  it("takes one angle of several where one is enough", () => {
    const tilt = {columns: ["tilt_x_deg", "tilt_y_deg"], least: 1, optional: []};
    const text = "id,kind,theta1_deg,tilt_x_deg,tilt_y_deg\nN1,tilt,3,,0.5\nN2,tilt,4,,\n";
    const fill = new Map([
      ["N1", tilt],
      ["N2", tilt],
    ]);
    expect(tableOf(filledRows(text, fill, "whole")).rows.map(([id]) => id)).toEqual(["N1"]);
  });
  it("tells a row that is refused from columns that are", () => {
    const text = "# made by hand\nid,kind\n1,position\n";
    expect(isOfRow("bad.csv:3 (kind)", text)).toBe(true);
    expect(isOfRow("bad.csv:2", text)).toBe(false);
    expect(isOfRow("bad.csv", text)).toBe(false);
    expect(isOfRow(undefined, text)).toBe(false);
  });
});
