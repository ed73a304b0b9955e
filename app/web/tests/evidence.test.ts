import {describe, expect, it} from "vitest";
import {binnedMeans, lawAlong} from "../../drawing/binned.js";
import {followedShare} from "../../drawing/groups.js";
import {viewOfCause, viewOfCauses} from "../../drawing/own_variable.js";
import {partsOf} from "../../drawing/error_parts.js";
import {loudest, multiplesOf, multiplesScale, panelPlaces} from "../../drawing/joint_multiples.js";
import {
  commonMost,
  errorsOfExplanation,
  errorsOfRefit,
  plotted,
  viewOfPair,
  viewOfPatterns,
  viewOfRemainder,
} from "../../drawing/reading_errors.js";
import {foldedRows, LEAST_FALL, MOST_RANKED} from "../../drawing/ranking.js";
import {columnsOf, filtered, rowsOf, sizeUnitOf, sorted, wrongWord} from "../source/error/reading_rows";
import {findVariable, variablesOf, variableTitle} from "../../drawing/variables.js";
import type {EffectAt, ErrorReading, LeverageDocument, MomentsDocument, Vector3} from "../source/server/documents";

// Arm with two revolute joints in a plane, the second at the end of a link of length 10; sixty readings, the world's z
// axis up.
const COUNT = 60;
const wave = (k: number) => ((k * 0.618034) % 1) * 2 - 1;
const readings: (ErrorReading & {temperature: number; time: number})[] = Array.from({length: COUNT}, (_, k) => ({
  id: String(k + 1),
  kind: "position",
  point: `P${k % 6}`,
  setup: k % 2 ? "a" : "b",
  joints: [80 * wave(k), 60 * wave(7 * k + 3)],
  senses: [k % 3 === 0 ? 1 : -1, k % 2 ? 1 : -1],
  load: 20 * (k % 3),
  temperature: 20 + 5 * wave(5 * k),
  time: 2 * k,
}));
const radians = Math.PI / 180;
const levers = readings.map(({joints}): [Vector3, Vector3] => {
  const [a, b] = [joints[0] * radians, (joints[0] + joints[1]) * radians];
  const tool: Vector3 = [-8 * Math.sin(b) * radians, 8 * Math.cos(b) * radians, 0];
  return [[tool[0] - 10 * Math.sin(a) * radians, tool[1] + 10 * Math.cos(a) * radians, 0], tool];
});
const places = readings.map(({joints}): Vector3 => {
  const [a, b] = [joints[0] * radians, (joints[0] + joints[1]) * radians];
  return [10 * Math.cos(a) + 8 * Math.cos(b), 10 * Math.sin(a) + 8 * Math.sin(b), 0];
});
const byId = <T>(of: (k: number) => T) => Object.fromEntries(readings.map(({id}, k) => [id, of(k)]));
const moments: MomentsDocument = {
  unit: "lbf*in",
  names: ["moment_tool_z"],
  readings: byId((k) => [300 * wave(11 * k)]),
};
const leverage: LeverageDocument = {
  units: ["deg", "deg", "deg"],
  names: ["theta1", "theta2", "tool.z"],
  base: [0, 0, 0],
  up: [0, 0, 1],
  tool: byId(() => [1, 0, 0, 0, 1, 0, 0, 0, 1]),
  readings: byId((k) => [...levers[k][0], ...levers[k][1], ...levers[k][1]]),
};
const source = {readings, joints: [{name: "theta1"}, {name: "theta2"}], places};
const conditions = [
  {name: "temperature", unit: "degC"},
  {name: "time", unit: "min"},
];
const variables = variablesOf(source, {angle: "deg", force: "lbf", conditions}, moments);
const parts = partsOf({ids: readings.map(({id}) => id), places, unit: {length: "in", angle: "deg"}, leverage});

const scaled = (v: Vector3, by: number): Vector3 => [v[0] * by, v[1] * by, v[2] * by];
const sign = (value: number) => (value > 0 ? 1 : -1);

/** Variables on which the law of each effect depends, as stated in the program's documents. */
const VARIES_WITH: Record<string, string[]> = {
  hysteresis: ["sense"],
  backlash: ["moment"],
  "base-slip": ["time"],
  "base-drift": ["time"],
  "thermal-growth": ["temperature"],
  "tool-remount": ["set-up"],
  "scale-error": ["position"],
  "payload-offset": ["load"],
  formula: [],
};

/** Returns the view on which the plot opens for a cause that displaces the tip by of(k) at reading k. */
function opened(effect: string, at: string, of: (k: number) => Vector3): [string, string] {
  const cause: EffectAt = {effect, at, varies_with: VARIES_WITH[effect] ?? ["joint"]};
  const view = viewOfCause(
    cause,
    readings.map((_, k) => of(k)),
    readings,
    variables,
    parts,
  )!;
  return [view.variable.key, view.part.key];
}

describe("the plot opens on the variable that the cause lives on", () => {
  it("for errors of a joint", () => {
    const turn = (j: 0 | 1, by: (k: number) => number) => (k: number) => scaled(levers[k][j], by(k));
    expect(
      opened(
        "hysteresis",
        "theta2",
        turn(1, (k) => 0.06 * readings[k].senses![1]),
      ),
    ).toEqual(["theta2_dir", "as theta2"]);
    expect(
      opened(
        "joint-offset",
        "theta1",
        turn(0, () => 0.3),
      ),
    ).toEqual(["theta1", "as theta1"]);
    expect(
      opened(
        "joint-scale",
        "theta2",
        turn(1, (k) => 0.01 * readings[k].joints[1]),
      ),
    ).toEqual(["theta2", "as theta2"]);
    expect(
      opened(
        "encoder-eccentricity",
        "theta1",
        turn(0, (k) => 0.1 * Math.sin(readings[k].joints[0] * radians)),
      ),
    ).toEqual(["theta1", "as theta1"]);
    expect(
      opened(
        "joint-coupling",
        "theta2<-theta1",
        turn(1, (k) => 0.01 * readings[k].joints[0]),
      ),
    ).toEqual(["theta1", "as theta2"]);
    expect(
      opened(
        "backlash",
        "tool.z",
        turn(1, (k) => 0.08 * sign(moments.readings[readings[k].id][0])),
      ),
    ).toEqual(["moment_tool_z", "as tool.z"]);
  });
  it("for errors of base, lengths and measurement", () => {
    expect(opened("base-slip", "base", (k) => (readings[k].time > 50 ? [0.05, 0.01, 0] : [0, 0, 0]))).toEqual([
      "time",
      "x",
    ]);
    expect(opened("base-drift", "base", (k) => [0, 0.001 * readings[k].time, 0])).toEqual(["time", "y"]);
    const grown = (k: number) => scaled(places[k], 1e-4 * (readings[k].temperature - 20));
    expect(opened("thermal-growth", "arm", grown)).toEqual(["temperature", "radial"]);
    expect(opened("tool-remount", "tool", (k) => (k % 2 ? [0.1, 0, 0] : [0, 0, 0]))).toEqual(["set-up", "x"]);
    expect(opened("scale-error", "measurement", (k) => scaled(places[k], 0.001))[0]).toMatch(/^position_[xy]$/);
    expect(opened("payload-offset", "payload", (k) => [0, 0, 0.001 * readings[k].load!])[0]).toBe("load");
  });
  it("for a formula, on what it names", () => {
    const law = (k: number) => scaled(levers[k][1], 0.1 * Math.sin(readings[k].joints[0] * radians));
    expect(opened("formula", "theta2 += c*sin(theta1)", law)).toEqual(["theta1", expect.any(String)]);
  });
});

describe("variables", () => {
  it("are those that differ, with the unit of their own joint", () => {
    const own = variablesOf(
      {
        readings: [
          {id: "1", joints: [1, 5]},
          {id: "2", joints: [2, 5]},
        ],
        joints: [{name: "slide", unit: "mm"}, {name: "turn"}],
        places: [],
      },
      {angle: "deg"},
    );
    expect(own.map(variableTitle)).toEqual(["slide, mm", "order of the readings"]);
    expect(variables.map(({kind}) => kind)).toContain("moment");
  });

  it("are whatever conditions the program serves", () => {
    const joints = [{name: "turn"}];
    const damp = [40, 55, 70].map((humidity, k) => ({id: String(k), joints: [k], humidity}));
    const found = variablesOf(
      {readings: damp, joints, places: []},
      {conditions: [{name: "humidity", unit: "percent"}]},
    );
    const own = found.find(({kind}) => kind === "humidity")!;
    expect(variableTitle(own)).toBe("humidity, percent");
    expect(damp.map(own.of)).toEqual([40, 55, 70]);
    expect(variablesOf({readings: damp, joints, places: []}, {}).map(({kind}) => kind)).not.toContain("humidity");
  });
});

describe("findings of the program", () => {
  it("are found by the names it gives them", () => {
    expect(findVariable("sense of theta2", variables)?.key).toBe("theta2_dir");
    expect(findVariable("direction of theta1", variables)?.key).toBe("theta1_dir");
    expect(findVariable("moment tool.z", variables)?.key).toBe("moment_tool_z");
    expect(findVariable("order of the readings", variables)?.key).toBe("order");
    expect(findVariable("theta1 and theta2", variables)?.key).toBe("theta1");
    expect(findVariable("constant", variables)).toBeNull();
  });
});

describe("binned", () => {
  it("a level is never cut, and its mean has the right error", () => {
    const means = binnedMeans([1, 1, 1, -1, -1], [2, 4, 6, 1, 3]);
    expect(means.map(({x, mean}) => [x, mean])).toEqual([
      [-1, 2],
      [1, 4],
    ]);
    expect(means[1].error).toBeCloseTo(2 / Math.sqrt(3));
  });
  it("noise follows nothing", () => {
    expect(
      followedShare(
        readings.map((_, k) => wave(k)),
        readings.map((_, k) => wave(13 * k * k + 1)),
      ),
    ).toBeLessThan(0.3);
    expect(followedShare([1, 2, 3, 4], [5, 5, 5, 5])).toBe(0);
  });
  it("a law is drawn through all that is there", () => {
    const law = lawAlong(
      readings.map(({time}) => time),
      readings.map(({time}) => (time! > 50 ? 1 : 0)),
    );
    expect(law.at(0)!.mean).toBe(0);
    expect(law.at(-1)!.mean).toBe(1);
  });
});

describe("the plot of several causes", () => {
  it("opens on the cause that moves the tip most", () => {
    const causes = ["theta1", "theta2"].map((at) => ({effect: "hysteresis", at, varies_with: ["sense"]}));
    const openedOn = (first: number, second: number) => {
      const done = readings.map(({senses}, k): Vector3 => {
        const [a, b] = [scaled(levers[k][0], first * senses![0]), scaled(levers[k][1], second * senses![1])];
        return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
      });
      return viewOfCauses(causes, done, readings, variables, parts)!.variable.key;
    };
    expect(openedOn(0.026, 0.012)).toBe("theta1_dir");
    expect(openedOn(0.004, 0.06)).toBe("theta2_dir");
  });
});

describe("errors before and after", () => {
  const document = {
    readings: readings.map((reading, k) => ({
      ...reading,
      position: places[k],
      before: scaled(levers[k][1], 0.06 * reading.senses![1]),
      explained: [[0, 0, 0] as Vector3, null],
    })),
    joints: [{name: "theta1"}, {name: "theta2"}],
    explanations: [
      {effects: [{effect: "hysteresis", at: "theta2", varies_with: ["sense"]}]},
      {effects: [{effect: "joint-scale", at: "theta1", varies_with: ["joint"]}], enough: false},
    ],
  };
  const pair = errorsOfExplanation(document, 0);
  it("are those without the explanation and with it, and the law what it takes away", () => {
    expect(pair.series.map(({name}) => name)).toEqual([
      "before: refitted without it",
      "after: with hysteresis at theta2",
    ]);
    const view = viewOfPair(pair, variables, parts)!;
    expect([view.variable.key, view.part.key]).toEqual(["theta2_dir", "as theta2"]);
    const {isLevel, law, means} = plotted(pair, view);
    expect(isLevel).toBe(true);
    expect(law.map(({x}) => x)).toEqual([-1, 1]);
    law.forEach(({x, mean, spread}, k) => {
      expect(mean).toBeCloseTo(0.06 * x);
      expect(spread).toBeCloseTo(0);
      expect(means[k].mean).toBeCloseTo(mean);
    });
    expect(commonMost([pair, view], [pair, view])).toBeCloseTo(0.06);
    expect(commonMost([pair, view], [pair, {...view, part: parts[0]}])).toBeNull();
  });
  it("have no causes where none is enough, and show what remains instead", () => {
    const other = errorsOfExplanation(document, 1);
    expect(other.causes).toEqual([]);
    expect(viewOfPair(other, variables, parts)).toBeNull();
    const remainder = {remainder: {follows: [{variable: "sense of theta2"}]}};
    expect(viewOfRemainder(remainder, pair, variables, parts)?.variable.key).toBe("theta2_dir");
    expect(viewOfRemainder({}, pair, variables, parts)).toBeNull();
    expect(viewOfPatterns([{variable: "point"}, {variable: "load", component: "z"}], variables, parts)).toMatchObject({
      variable: {key: "load"},
      part: {key: "z"},
    });
  });
  it("joint by joint: the most significant is the loudest, and all panels have one scale", () => {
    const tested = [
      {variable: "sense of theta2", p_value: 1e-20},
      {variable: "theta2", p_value: 0.5},
      {variable: "load", p_value: null},
    ];
    const multiples = multiplesOf({errors: pair, variables, parts, tested, rowOf: () => "tool"});
    expect(loudest(multiples)).toMatchObject({joint: "theta2", column: "direction", p: 1e-20});
    expect(loudest(multiples.filter(({p}) => p !== 1e-20))).toBeNull();
    expect(multiples.find(({joint, column}) => joint === "theta2" && column === "load")?.p).toBeNull();
    const {points, means, zero} = panelPlaces(loudest(multiples)!, pair, multiplesScale(multiples, pair), 200, 60);
    expect(points.map((places) => places.length)).toEqual([COUNT, COUNT]);
    expect(zero).toBe(30);
    expect(means).toHaveLength(2);
    for (const [x, y] of points.flat()) expect(x >= 0 && x <= 200 && y >= 0 && y <= 60).toBe(true);
  });
});

describe("the table of readings", () => {
  const measured = readings.map((reading, k) => ({
    ...reading,
    position: [0, 0, 0.1 * k] as Vector3,
    tip: [0, 0, 0] as Vector3,
    set_aside: k === 4,
  }));
  const rows = rowsOf(measured, null, "m");
  const columns = columnsOf(
    [
      {name: "theta1", unit: "deg"},
      {name: "lift", unit: "m"},
    ],
    {length: "m", angle: "deg", force: "N"},
  );
  it("sorts by any column, what is missing last", () => {
    const by = (key: string, isDown: boolean) =>
      sorted(
        rows,
        columns.find((column) => column.key === key)!,
        isDown,
      );
    expect(by("before", true)[0].id).toBe("60");
    expect(by("id", false)[1].id).toBe("2");
    expect(by("after", true)).toHaveLength(COUNT);
  });
  it("filters by words and by figures", () => {
    expect(filtered(rows, "P3", columns)).toHaveLength(10);
    expect(filtered(rows, "load=40 theta1>0", columns).every((row) => row.load === 40 && row.joints[0] > 0)).toBe(true);
    expect(wrongWord("P3 load=40 theta1>0", columns)).toBeNull();
    expect(wrongWord("theta3<foo", columns)).toBe("theta3<foo");
    expect(wrongWord("nothing>1", columns)).toBe("nothing>1");
    expect(filtered(rows, "aside", columns).map((row) => row.id)).toEqual(["5"]);
  });
  it("says the units", () => {
    expect(columns.map(({unit}) => unit)).toEqual(["", "", "m", "m", "", "N", "deg", "m"]);
  });
  // A reading of angles has no position error: its error vector is zero, and its size is an angle.
  const turnedErrors = (isTurn: (index: number) => boolean) => ({
    ...errorsOfRefit(
      readings,
      readings.map(() => null),
      [],
      readings.map((_, k): Vector3 => (isTurn(k) ? [0, 0, 0] : [0, 0, 1e-3])),
      readings.map((): Vector3 => [0, 0, 0]),
    ),
    sigmas: [readings.map(() => 1), readings.map(() => 1)],
    sizes: [0.5, 0.25].map((turn) => readings.map((_, k) => (isTurn(k) ? turn : 1e-3))),
    sizeUnits: readings.map((_, k) => (isTurn(k) ? "deg" : "m")),
  });
  it.each(["orientation", "tilt", "direction"])("has the errors of readings of kind %s as angles", (kind) => {
    const ofAngles = measured.map((row) => ({...row, kind, set_aside: false}));
    const all = rowsOf(
      ofAngles,
      turnedErrors(() => true),
      "m",
    );
    for (const {before, after, sizeUnit} of all) expect([before, after, sizeUnit]).toEqual([0.5, 0.25, "deg"]);
    expect(sizeUnitOf(all, "m")).toBe("deg");
    const units = {length: "m", angle: "deg", force: "N"};
    expect(columnsOf([], units, sizeUnitOf(all, "m")).map(({unit}) => unit)).toEqual(["", "", "deg", "deg", "", "N"]);
  });
  it("leaves the unit to the rows where lengths and angles are both measured", () => {
    const all = rowsOf(
      measured,
      turnedErrors((k) => k % 2 === 0),
      "m",
    );
    expect(all[0]).toMatchObject({before: 0.5, sizeUnit: "deg"});
    expect(all[1]).toMatchObject({before: 1e-3, sizeUnit: "m"});
    expect(sizeUnitOf(all, "m")).toBe("");
    expect(sizeUnitOf([], "m")).toBe("m");
  });
});

describe("the ranking", () => {
  const row = (chi2_fall: number | null) => ({entry: {effect: "backlash", at: "theta1", chi2_fall}});

  it("folds the effects that lower chi-square no more than noise does", () => {
    const rows = [row(90), row(LEAST_FALL), row(LEAST_FALL - 0.1), row(0)];
    expect(foldedRows(rows)).toEqual({shown: rows.slice(0, 2), folded: rows.slice(2), isWeak: true});
  });

  it("folds what exceeds the number of rows, and says that not all of it is weak", () => {
    const rows = Array.from({length: MOST_RANKED + 3}, () => row(90));
    const {shown, folded, isWeak} = foldedRows(rows);
    expect([shown.length, folded.length, isWeak]).toEqual([MOST_RANKED, 3, false]);
  });

  it("shows effects of unknown decrease", () => {
    expect(foldedRows([row(null)]).folded).toEqual([]);
  });
});
