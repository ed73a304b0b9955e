// Tests of the calibrate view's words on touches, including refused ones, and of touches among readings.
import {describe, expect, it} from "vitest";
import type {CalibrateDocument, MeasurementRow} from "../source/server/documents";
import {readingWords, suspicionOf} from "../source/calibrate/suspicion";
import {areTouches, touchesAmong, touchTable} from "../source/calibrate/touch_readings";

const units = {length: "in", angle: "deg", force: "lbf"};
const refused: CalibrateDocument = {
  status: "refused",
  reason: "the touches fit neither the holes they name nor any of their neighbours",
  suspects: [],
  odd_touch: "T4",
  suspect_readings: [
    {touch: "T4", joint: "theta1", off: 0.4, unit: "deg", p_value: 0.4},
    {touch: "T4", joint: "theta2", off: -1.25, unit: "deg", p_value: 0.1},
    {touch: "T2", joint: "slide", off: -0.003, unit: "in", p_value: 0.02},
  ],
  units,
};

describe("a suspected touch", () => {
  it("is the odd one, or has a joint reading that explains the misfit", () => {
    expect(suspicionOf(refused, "T4")).toEqual({
      isOutlier: true,
      words: "does not agree with the others; theta1 read 0.400 deg too large?; theta2 read 1.25 deg too small?",
    });
    expect(suspicionOf(refused, "T2")).toEqual({isOutlier: false, words: "slide read 0.0030 in too small?"});
    expect(suspicionOf({...refused, suspect_readings: []}, "T4")?.words).toBe("does not agree with the others");
  });
  it("is none where nothing is suspected, or nothing is known", () => {
    expect(suspicionOf(refused, "T1")).toBeNull();
    expect(suspicionOf(null, "T4")).toBeNull();
    const bare: CalibrateDocument = {status: "refused", reason: "two touches", suspects: [], units};
    for (const document of [bare, {...bare, odd_touch: null}]) expect(suspicionOf(document, "T4")).toBeNull();
  });
  it("names the reading by its joint, size, unit and sense", () => {
    expect(readingWords({touch: "T1", joint: "A1", off: 0.0123, unit: "rad", p_value: 1})).toBe(
      "A1 read 0.0123 rad too large?",
    );
  });
});

describe("touches among the readings", () => {
  const row = (id: string, more: Partial<MeasurementRow> = {}): MeasurementRow => ({
    ...{id, kind: "touch", point: "R10C20", joints: [1, 2], load: 5, position: null, tip: null, set_aside: false},
    ...more,
  });
  it("are those of holes that are not set aside", () => {
    const rows = [row("A"), row("B", {set_aside: true}), row("C", {point: "cone"}), row("D", {kind: "position"})];
    expect(touchesAmong(rows).map(({id}) => id)).toEqual(["A"]);
    expect(areTouches(rows)).toBe(false);
    expect(areTouches(rows.slice(0, 2))).toBe(true);
    expect(areTouches([])).toBe(false);
  });
  it("take a further touch as a row with an id of its own and their load", () => {
    const joints = [
      {name: "theta1", unit: "deg"},
      {name: "slide", unit: "in"},
    ];
    expect(touchTable({point: "R1\u00a0C2", values: [1.5, -2]}, [row("T2"), row("T3")], joints, "lbf")).toBe(
      "id,kind,point,load_lbf,theta1_deg,slide_in\nT4,touch,R1C2,5,1.5,-2\n",
    );
  });
});
